// The maker's libraries publish a Jacobian that finds the distal angles as acos of an x difference,
// which loses their sign: it is right only while the tip lies beyond both elbows. It is kept here
// so that nobody "corrects" ours by it.

#include "haptics/pantograph/kinematics.h"
#include "tests/haptics/pantograph/workspace.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace touchline {
namespace {

Jacobian published_jacobian(const Geometry& g, JointAngles angles, Position tip) {
    const double l = g.proximal_m;
    const double c1 = std::cos(angles.x), s1 = std::sin(angles.x);
    const double c2 = std::cos(angles.y), s2 = std::sin(angles.y);
    const double phi_1 = std::acos((tip.x - l * c1) / g.distal_m);
    const double phi_2 = std::acos((tip.x - g.base_m - l * c2) / g.distal_m);
    const double c11 = std::cos(phi_1), s11 = std::sin(phi_1);
    const double c22 = std::cos(phi_2), s22 = std::sin(phi_2);
    const double L = g.distal_m;
    const double dn = L * (c11 * s22 - c22 * s11);
    const double eta = (-L * c11 * s22 + L * c22 * s11 - c1 * l * s22 + c22 * l * s1) / dn;
    const double nu = l * (c2 * s22 - c22 * s2) / dn;
    return {{-L * eta * s11 - L * s11 - l * s1, L * c11 * eta + L * c11 + c1 * l},
            {-L * s11 * nu, L * c11 * nu}};
}

double difference(const Jacobian& a, const Jacobian& b) {
    return norm(a.joint_1 - b.joint_1) + norm(a.joint_2 - b.joint_2);
}

TEST(PublishedVersion, FailsWhereTheTipIsNearerTheBaseThanAnElbow) {
    int wrong = 0;
    int all = 0;
    for (double x = -0.056; x <= 0.0941; x += 0.0025) {
        for (double y = 0.030; y <= 0.1401; y += 0.0025) {
            const auto angles = inverse(gen3, {x, y});
            if (!angles) continue;
            const Pose pose = forward(gen3, *angles).value();
            const double elbow_y =
                gen3.proximal_m * std::max(std::sin(angles->x), std::sin(angles->y));
            const double off =
                difference(published_jacobian(gen3, *angles, pose.p_DH), pose.jacobian);
            ++all;
            if (y > elbow_y + 1e-6) {
                EXPECT_LE(off, 1e-6) << x << ' ' << y;
            } else {
                EXPECT_GT(off, 1e-6) << x << ' ' << y;
                ++wrong;
            }
        }
    }
    EXPECT_NEAR(static_cast<double>(wrong) / all, 0.25, 0.02) << wrong << " of " << all;
}

}  // namespace
}  // namespace touchline
