#include "app/screen/window.h"

#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double pi = std::numbers::pi;

TEST(Knob, TheFirstReadingTurnsNothing) {
    Knob knob;
    EXPECT_EQ(knob.step(0.7), 0.0);
    EXPECT_NEAR(knob.step(0.2), 0.5 * pi, 1e-12);  // counter-clockwise is positive
    EXPECT_NEAR(knob.step(0.45), -0.25 * pi, 1e-12);
}

TEST(Knob, AnEndlessOneGoesOnPastTheEndOfItsAxis) {
    Knob knob;
    (void)knob.step(0.95);
    EXPECT_NEAR(knob.step(-0.95), -0.1 * pi, 1e-12);
}

TEST(Knob, NoiseTurnsNothingAndSlowTurningIsNotLost) {
    Knob knob;
    (void)knob.step(0.0);
    double turned_rad = 0.0;
    for (int i = 1; i <= 100; ++i) turned_rad += knob.step(0.003 * (i % 2));
    EXPECT_EQ(turned_rad, 0.0);
    for (int i = 1; i <= 100; ++i) turned_rad += knob.step(0.001 * i);
    EXPECT_NEAR(turned_rad, -0.1 * pi, 0.01 * pi);
}

TEST(Knob, OneThatIsPulledOutAndPutInBeginsAnew) {
    Knob knob;
    (void)knob.step(0.9);
    EXPECT_EQ(knob.step(std::nullopt), 0.0);
    EXPECT_EQ(knob.step(-0.5), 0.0);
    EXPECT_EQ(knob.step(std::numeric_limits<double>::quiet_NaN()), 0.0);
}

}  // namespace
}  // namespace touchline
