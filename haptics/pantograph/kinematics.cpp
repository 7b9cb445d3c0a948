#include "haptics/pantograph/kinematics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace touchline {
namespace {

Position elbow(double motor_x_m, double proximal_m, double angle_rad) {
    return {motor_x_m + proximal_m * std::cos(angle_rad), proximal_m * std::sin(angle_rad)};
}

// Returns the angle of a vector, in (-pi/2, 3 pi/2]: the cut lies straight behind the motor, out of
// the way.
double bearing(Position v) {
    return std::numbers::pi / 2.0 - std::atan2(v.x, v.y);
}

// Returns the angle at the motor between the direction of the tip and the proximal link; NaN if out
// of reach.
double motor_angle(const Geometry& g, double reach_m) {
    const double cosine =
        (g.proximal_m * g.proximal_m + reach_m * reach_m - g.distal_m * g.distal_m) /
        (2.0 * g.proximal_m * reach_m);
    return std::acos(cosine);
}

double determinant(const Jacobian& j) {
    return cross(j.joint_1, j.joint_2);
}

}  // namespace

std::optional<Pose> forward(const Geometry& geometry, JointAngles angles) {
    const Position a = elbow(0.0, geometry.proximal_m, angles.x);
    const Position b = elbow(geometry.base_m, geometry.proximal_m, angles.y);
    const Position h = b - a;
    const double m = norm(h);
    const double height_squared = geometry.distal_m * geometry.distal_m - 0.25 * m * m;
    if (!(m > 0.0) || !(height_squared > 0.0)) return std::nullopt;

    const Position tip = 0.5 * (a + b) + std::sqrt(height_squared) / m * left_of(h);
    const Position u = tip - a;
    const Position v = tip - b;
    const double area = cross(u, v);
    const double alpha = cross(a, u);
    const double beta = cross(b - Position{geometry.base_m, 0.0}, v);
    const bool is_working_branch = area > 0.0 && alpha <= 0.0 && beta >= 0.0;
    if (!is_working_branch) return std::nullopt;

    const Jacobian jacobian{along<TipPerTurn>(left_of(v), -alpha / area),
                            along<TipPerTurn>(left_of(u), beta / area)};
    if (!is_finite(tip) || !is_finite(jacobian)) return std::nullopt;
    return Pose{tip, jacobian};
}

std::optional<JointAngles> inverse(const Geometry& geometry, Position p_DH) {
    const Position from_1 = p_DH;
    const Position from_2 = p_DH - Position{geometry.base_m, 0.0};
    const JointAngles angles{bearing(from_1) + motor_angle(geometry, norm(from_1)),
                             bearing(from_2) - motor_angle(geometry, norm(from_2))};
    if (!is_finite(angles)) return std::nullopt;
    // The same links also close on the other side of both elbows, but that branch is not this
    // tip's.
    const Position a = elbow(0.0, geometry.proximal_m, angles.x);
    const Position b = elbow(geometry.base_m, geometry.proximal_m, angles.y);
    if (!(cross(p_DH - a, p_DH - b) > 0.0)) return std::nullopt;
    return angles;
}

JointTorques joint_torques(const Jacobian& jacobian, Force force_D) {
    return {dot(jacobian.joint_1, force_D), dot(jacobian.joint_2, force_D)};
}

std::optional<Force> tip_force(const Jacobian& jacobian, JointTorques torques) {
    const double d = determinant(jacobian);
    const Force scaled{torques.x * jacobian.joint_2.y - torques.y * jacobian.joint_1.y,
                       torques.y * jacobian.joint_1.x - torques.x * jacobian.joint_2.x};
    const Force force{scaled.x / d, scaled.y / d};
    return is_finite(force) ? std::optional(force) : std::nullopt;
}

SingularValues singular_values(const Jacobian& jacobian, JointAngles step) {
    const TipPerTurn p = step.x * jacobian.joint_1;
    const TipPerTurn q = step.y * jacobian.joint_2;
    const double largest =
        0.5 * (std::hypot(p.x + q.y, p.y - q.x) + std::hypot(p.x - q.y, p.y + q.x));
    const double smallest = largest > 0.0 ? std::abs(cross(p, q)) / largest : 0.0;
    return {largest, smallest};
}

double condition(const Jacobian& jacobian) {
    const SingularValues s = singular_values(jacobian);
    return s.smallest > 0.0 ? std::max(1.0, s.largest / s.smallest)
                            : std::numeric_limits<double>::infinity();
}

}  // namespace touchline
