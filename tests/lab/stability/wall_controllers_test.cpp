// How the methods fail, against the reference: the largest stiffness that comes to rest after an
// impact, and what stored energy costs the observer.

#include "tests/lab/stability/wall_controllers.h"

#include "tests/lab/stability/wall_run.h"

#include <cmath>

#include <gtest/gtest.h>

namespace touchline::stability {
namespace {

constexpr double encoder_m = 20e-6;
const StiffnessGrid coarse_grid{50.0, std::pow(800.0, 1.0 / 89.0), 90};

/// Impact at 0.1 m/s and 1 N: returns the last stiffness before the first that does not come to
/// rest.
double settled_stiffness(std::string_view name, double period_s, double delay_s,
                         const HandModel& hand) {
    WallLoop loop{period_s, delay_s, {}, hand};
    loop.encoder_step_m = encoder_m;
    return scanned_stiffness(coarse_grid, [&](double stiffness) {
        const WallTrace trace = render(method(name), stiffness, loop, {}, 2.0);
        return peak_to_peak_m(trace, 0.8, 1.0) < 3.0 * encoder_m;
    });
}

struct Measured {
    double period_s, delay_s;
    HandModel hand;
    // spring, LP100 B = 2, LP100 B = 5, FOAW16, slope bound
    double stiffness[5];
};

TEST(Methods, ComeToRestUpToTheReferenceStiffness) {
    const Measured rows[] = {
        {2e-3, 0, no_hand, {327, 2138, 3898, 2304, 98}},
        {2e-3, 0, light_hand, {1706, 3616, 5264, 3616, 1087}},
        {2e-3, 1e-3, no_hand, {114, 1009, 1839, 1087, 50}},
        {2e-3, 1e-3, light_hand, {747, 1706, 2678, 1706, 553}},
        {1e-3, 0, no_hand, {936, 4530, 7664, 4883, 208}},
        {1e-3, 0, light_hand, {4202, 7664, 11157, 7664, 2304}},
        {1e-3, 1e-3, no_hand, {179, 1468, 2678, 1468, 68}},
        {1e-3, 1e-3, light_hand, {1087, 2304, 3616, 2304, 747}},
    };
    constexpr std::string_view names[] = {"spring", "spring + LP100", "spring + LP100, B = 5",
                                          "spring + FOAW16", "slope bound"};
    for (const Measured& row : rows) {
        for (int i = 0; i < 5; ++i) {
            const double found = settled_stiffness(names[i], row.period_s, row.delay_s, row.hand);
            EXPECT_NEAR(found, row.stiffness[i], 0.081 * row.stiffness[i])
                << names[i] << ", T " << row.period_s << ", delay " << row.delay_s;
        }
    }
}

TEST(Methods, TheEnergyObserverLosesItsAdvantageToDelay) {
    for (const std::string_view name : {"energy observer", "energy observer, cap 30"}) {
        EXPECT_NEAR(settled_stiffness(name, 2e-3, 0.0, no_hand), 8262, 0.081 * 8262) << name;
        const double delayed = settled_stiffness(name, 2e-3, 1e-3, no_hand);
        EXPECT_GE(delayed, 224.0) << name;
        EXPECT_LE(delayed, 243.0) << name;
        EXPECT_NEAR(settled_stiffness(name, 1e-3, 1e-3, no_hand), 281, 0.081 * 281) << name;
    }
}

TEST(Methods, TheEnergyObserverSpendsStoredEnergyOnRinging) {
    struct Credit {
        double saved_J, ringing_mm;
    };

    for (const Credit& credit :
         {Credit{0.0, 1.2}, Credit{1e-3, 2.6}, Credit{1e-2, 10.9}, Credit{1e-1, 58.0}}) {
        WallLoop loop{1e-3, 0.0, {0.05, 0.1, 0.0}};
        loop.substeps = 20;
        EnergyObserverWall wall(2000.0, loop.period_s, 0.0, 20.0, credit.saved_J);
        const WallTrace trace = run(
            loop, {0.0, 0.05, 1.0}, [&](double x_m) { return wall.step(x_m); }, 3.0);
        double ringing_m = 0.0;
        const auto count = static_cast<double>(trace.x_m.size());
        for (double first = 0.0; first + 100.0 < count; first += 50.0) {
            ringing_m =
                std::max(ringing_m, peak_to_peak_m(trace, first / count, (first + 100.0) / count));
        }
        EXPECT_NEAR(1e3 * ringing_m, credit.ringing_mm, 0.03 * credit.ringing_mm + 0.05);
    }
}

TEST(Methods, ALocalModelIsAsStiffAsItsOwnRate) {
    EXPECT_NEAR(settled_stiffness("local model", 1e-3, 0.0, no_hand), 7664, 0.081 * 7664);
}

TEST(LocalModel, NoticesThatTheWallMovedWhenGeometryIsDue) {
    LocalModelWall wall(1000.0, 4);
    EXPECT_DOUBLE_EQ(wall.step(1e-3, 0.0), -1.0);
    for (int k = 0; k < 3; ++k) EXPECT_DOUBLE_EQ(wall.step(1e-3, 0.5e-3), -1.0);
    EXPECT_DOUBLE_EQ(wall.step(1e-3, 0.5e-3), -0.5);
}

TEST(DampedWallForce, OnlyPushes) {
    DampedWall wall(100.0, 5.0, FilteredDifference(1e-3, 10e-3));
    EXPECT_EQ(wall.step(5e-3), 0.0);  // out at 5 m/s: spring and damper together would pull
}

TEST(Methods, AreFoundByTheirNames) {
    for (const Method& each : methods()) EXPECT_EQ(&method(each.name), &each);
}

}  // namespace
}  // namespace touchline::stability
