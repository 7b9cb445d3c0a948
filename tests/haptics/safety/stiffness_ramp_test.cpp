#include "haptics/safety/stability_monitor.h"
#include "tests/haptics/safety/chains.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(StiffnessRamp, RisesByFivePerCentASecond) {
    StiffnessRamp ramp(500.0);
    for (int i = 0; i < 1000; ++i) (void)ramp.step(1000.0, 0.0, 1e-3);
    EXPECT_NEAR(ramp.stiffness_N_per_m(), 500.0 * std::exp(0.05), 0.01);
}

TEST(StiffnessRamp, FallsUnderAHandByFifteenNewtonsASecond) {
    StiffnessRamp ramp(500.0);
    EXPECT_NEAR(ramp.step(200.0, 0.003, 1e-3), 500.0 - 5.0, 1e-9);
    EXPECT_NEAR(ramp.step(200.0, -0.001, 1e-3), 495.0 - 15.0, 1e-9);
}

TEST(StiffnessRamp, FallsAtOnceWhereNothingPressesAndStopsAtTheWantedValue) {
    StiffnessRamp ramp(500.0);
    EXPECT_EQ(ramp.step(200.0, 0.0, 1e-3), 200.0);
    for (int i = 0; i < 2000; ++i) (void)ramp.step(210.0, 0.0, 1e-3);
    EXPECT_EQ(ramp.stiffness_N_per_m(), 210.0);
    StiffnessRamp soft(2.0);
    EXPECT_EQ(soft.step(0.5, 0.0, 1e-3), 0.5);
}

TEST(StiffnessRamp, BooksTheEnergyPutIntoTheSpring) {
    StiffnessRamp ramp(400.0);
    (void)ramp.step(1e6, 0.003, 0.5);
    EXPECT_NEAR(ramp.booked_J(), 0.5 * 10.0 * 9e-6, 1e-15);
    (void)ramp.step(400.0, 0.003, 2e-3);
    EXPECT_NEAR(ramp.booked_J(), 0.0, 1e-15);
}

TEST(StiffnessRamp, NonsenseChangesNothing) {
    StiffnessRamp ramp(500.0);
    for (const double bad : {nan, 0.0, -1.0, std::numeric_limits<double>::infinity()}) {
        EXPECT_EQ(ramp.step(bad, 0.001, 1e-3), 500.0);
    }
    EXPECT_EQ(ramp.step(600.0, nan, 1e-3), 500.0);
    EXPECT_EQ(ramp.step(600.0, std::numeric_limits<double>::infinity(), 1e-3), 500.0);
    for (const double bad_s : {nan, 0.0, -1e-3, std::numeric_limits<double>::infinity()})
        EXPECT_EQ(ramp.step(600.0, 0.001, bad_s), 500.0);
    EXPECT_EQ(ramp.step(200.0, 0.001, 0.0), 500.0);
    EXPECT_EQ(ramp.booked_J(), 0.0);
}

}  // namespace
}  // namespace touchline
