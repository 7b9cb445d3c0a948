// R7: with the curve fixed a step never adds energy, so the work per sample is bounded; and a hand
// at rest finds the shape at rest.

#include "tests/haptics/probe/hands.h"
#include "tests/haptics/scenes.h"

#include <cmath>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double k_N_per_m = 500.0;

double energy_J(const ProbeShape& shape, const ProbePose& proxy, const ProbePose& hand) {
    const ProbeMove left = proxy - hand;
    return 0.5 * k_N_per_m * dot(left.by, left.by) +
           0.5 * turn_stiffness_Nm_per_rad(shape, k_N_per_m) * left.turn_rad * left.turn_rad;
}

TEST(ProbeEnergy, NoStepAddsAnyAndTheWorkPerSampleIsBounded) {
    const std::size_t steps = trials::count(2000, 50000);
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const Scene scene =
            trials::scene_of(scenes::random_map(static_cast<unsigned>(seed), 5), seed);
        const ProbeShape shape = any_shape(seed % 6);
        RestlessHand hand(seed);
        ProbePose at = hand.step();
        ProbeProxy proxy;
        proxy.reset(shape, scene, at, 0.0);
        ProbeReport last = proxy.step(at, 0.0, {}, {});
        double worked_J = 0.0;
        double allowed_J = 0.0;
        for (std::size_t k = 0; k < steps; ++k) {
            const ProbePose next = hand.step();
            const ProbeMove by = next - at;
            const double before_J = energy_J(shape, proxy.pose(), next);
            const ProbeReport report = proxy.step(next, 0.0, {}, {});
            const bool was_placed = last.is_placed;
            if (was_placed) {
                // Rounding counts where a hand far off has stored a joule.
                const double rounding_J = 1e-15 * (1.0 + before_J);
                ASSERT_LE(report.stored_J, before_J + rounding_J)
                    << "seed " << seed << " step " << k;
                const double work_J = dot(last.force, by.by) + last.torque_Nm * by.turn_rad;
                worked_J += work_J;
                allowed_J += energy_J(shape, {}, ProbePose{} + by);
                ASSERT_LE(work_J - (last.stored_J - report.stored_J),
                          energy_J(shape, {}, ProbePose{} + by) + rounding_J);
            }
            at = next;
            last = report;
        }
        EXPECT_LE(worked_J, allowed_J) << seed;
    }
}

TEST(ProbeEnergy, AHandAtRestFindsTheShapeAtRest) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const Scene scene =
            trials::scene_of(scenes::random_map(static_cast<unsigned>(seed), 5), seed);
        const ProbeShape shape = any_shape(seed % 6);
        RestlessHand hand(seed);
        ProbeProxy proxy;
        proxy.reset(shape, scene, hand.step(), 0.0);
        ProbePose at;
        for (int k = 0; k < 1500; ++k) (void)proxy.step(at = hand.step(), 0.0, {}, {});
        for (int k = 0; k < 200; ++k) (void)proxy.step(at, 0.0, {}, {});
        const ProbePose settled = proxy.pose();
        for (int k = 0; k < 10000; ++k) (void)proxy.step(at, 0.0, {}, {});
        const ProbeMove drift = proxy.pose() - settled;
        EXPECT_LT(norm(drift.by), 1e-9) << seed;
        EXPECT_LT(std::abs(drift.turn_rad), 1e-7) << seed;
    }
}

}  // namespace
}  // namespace touchline
