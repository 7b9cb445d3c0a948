// Checks the simulation against the oldest result on virtual walls: a spring of stiffness K,
// sampled at period T and acting after a delay, is stable up to about b / (T/2 + delay), and
// exactly up to the eigenvalue limits below.

#include "haptics/device/simulated/simulated_pantograph.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

struct WallCase {
    double mass_kg, damping_Ns_per_m, period_s, delay_periods;
    double limit_N_per_m;  // largest stable K, from the eigenvalues of the sampled loop
};

// Returns the amplitude late in the run over the amplitude early in it; > 1 grows.
double growth(const WallCase& wall, double stiffness_N_per_m) {
    constexpr int substeps = 32;
    const double h_s = wall.period_s / substeps;
    const int delay_substeps = static_cast<int>(std::lround(wall.delay_periods * substeps));
    const int ticks = static_cast<int>(6.0 / wall.period_s);

    TipDynamics tip({wall.mass_kg, wall.damping_Ns_per_m, 0.0}, no_hand, {1e-3, 0.0});
    std::vector<Force> commanded;
    double early_m = 0.0;
    double late_m = 0.0;
    for (int k = 0; k < ticks; ++k) {
        const double x = tip.tip().position.x;
        commanded.push_back({-stiffness_N_per_m * x, 0.0});
        for (int i = 0; i < substeps; ++i) {
            const int sent = k * substeps + i - delay_substeps;
            tip.step(sent < 0 ? Force{} : commanded[static_cast<std::size_t>(sent / substeps)], {},
                     h_s);
        }
        if (k > ticks / 6 && k < ticks / 2) early_m = std::max(early_m, std::abs(x));
        if (k > 2 * ticks / 3) late_m = std::max(late_m, std::abs(x));
    }
    return late_m / early_m;
}

TEST(SampledWall, IsStableUpToTheEigenvalueLimitAndNotBeyond) {
    const WallCase cases[] = {
        {0.05, 0.5, 1e-3, 0.0, 1001.67}, {0.05, 0.5, 1e-3, 0.5, 501.04},
        {0.05, 0.5, 1e-3, 1.0, 334.26},  {0.05, 0.5, 1e-3, 2.0, 200.86},
        {0.05, 0.1, 2e-3, 0.0, 100.07},  {0.05, 0.1, 2e-3, 1.0, 33.37},
        {0.20, 5.0, 2e-3, 0.0, 5042.02}, {0.20, 5.0, 2e-3, 1.0, 1689.47},
    };
    for (const WallCase& wall : cases) {
        EXPECT_LT(growth(wall, 0.98 * wall.limit_N_per_m), 1.0) << wall.limit_N_per_m;
        EXPECT_GT(growth(wall, 1.02 * wall.limit_N_per_m), 1.0) << wall.limit_N_per_m;
    }
}

}  // namespace
}  // namespace touchline
