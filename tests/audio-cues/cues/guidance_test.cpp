#include "audio-cues/cues/guidance.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(Guidance, PulsesGetQuickerAsTheLineComesNearer) {
    EXPECT_NEAR(distance_tone(far_m).pulse_Hz, slow_Hz, 1e-9);
    EXPECT_NEAR(distance_tone(near_m).pulse_Hz, quick_Hz, 1e-9);
    EXPECT_NEAR(distance_tone(near_m * 0.6).pulse_Hz, quick_Hz, 1e-9);
    const double halving = distance_tone(0.006).pulse_Hz / distance_tone(0.012).pulse_Hz;
    EXPECT_GT(halving, 1.3);
    EXPECT_NEAR(distance_tone(0.003).pulse_Hz / distance_tone(0.006).pulse_Hz, halving, 1e-9);
}

TEST(Guidance, OnTheLineAndFarFromAnyIsSilence) {
    for (const double distance_m : {0.0, -1.0, 0.0005, 0.0151, infinite, none}) {
        EXPECT_EQ(distance_tone(distance_m).level, 0.0) << distance_m;
    }
    EXPECT_GT(distance_tone(0.0006).level, 0.0);
    EXPECT_GT(distance_tone(0.0149).level, 0.0);
}

TEST(Guidance, ThePositionToneIsPanAndTwoOctaves) {
    const CueArea area;
    EXPECT_NEAR(pitch_Hz_of({0.0, -0.042}, area), 220.0, 1e-9);
    EXPECT_NEAR(pitch_Hz_of({0.0, 0.0}, area), 440.0, 1e-9);
    EXPECT_NEAR(pitch_Hz_of({0.0, 0.042}, area), 880.0, 1e-9);
    EXPECT_NEAR(pitch_Hz_of({0.0, 0.1}, area), 880.0, 1e-9);
    EXPECT_NEAR(pitch_Hz_of({0.0, none}, area), 440.0, 1e-9);
    EXPECT_NEAR(position_tone({-0.029, 0.0}, area).pan, -0.5, 1e-12);
    EXPECT_EQ(position_tone({1.0, 0.0}, area).pan, 1.0);
    EXPECT_EQ(position_tone({none, 0.0}, area).pan, 0.0);
    EXPECT_EQ(position_tone({0.0, 0.0}, area).pulse_Hz, 0.0);
}

TEST(Guidance, SonarTellsSideHeightAndDistance) {
    const Position hand{0.01, 0.01};
    const ContinuousTone right = sonar_tone(hand, {0.03, 0.01});
    EXPECT_EQ(right.pan, 1.0);
    EXPECT_NEAR(right.frequency_Hz, 660.0, 1e-9);
    const ContinuousTone away = sonar_tone(hand, {0.01, 0.03});
    EXPECT_EQ(away.pan, 0.0);
    EXPECT_NEAR(away.frequency_Hz, 1320.0, 1e-9);
    EXPECT_NEAR(sonar_tone(hand, {0.01, -0.03}).frequency_Hz, 330.0, 1e-9);
    EXPECT_GT(sonar_tone(hand, {0.013, 0.01}).pulse_Hz, right.pulse_Hz);
    EXPECT_EQ(sonar_tone(hand, {0.0105, 0.01}).level, 0.0) << "reached";
    EXPECT_EQ(sonar_tone(hand, {none, 0.01}).level, 0.0);
}

TEST(Guidance, OneContinuousSoundAtATime) {
    const CueArea area;
    ContinuousChoice choice;
    EXPECT_EQ(continuous_tone(choice, {0.0, 0.0}, 0.01, area).level, 0.0) << "cues only";
    choice.amount = CueAmount::full;
    EXPECT_GT(continuous_tone(choice, {0.0, 0.0}, 0.01, area).pulse_Hz, 0.0) << "the distance";
    choice.has_position_tone = true;
    EXPECT_EQ(continuous_tone(choice, {0.0, 0.042}, 0.01, area).frequency_Hz, 880.0);
    choice.target_W = Position{0.02, 0.0};
    EXPECT_EQ(continuous_tone(choice, {0.0, 0.0}, 0.01, area).pan, 1.0) << "the target";
    choice.amount = CueAmount::none;
    EXPECT_GT(continuous_tone(choice, {0.0, 0.0}, 0.01, area).level, 0.0) << "it was asked for";
}

TEST(Guidance, TheNinePlacesAreThirdsOfTheArea) {
    const CueArea area;
    EXPECT_EQ(place_of({-0.05, 0.04}, area), Place::upper_left);
    EXPECT_EQ(place_of({0.0, 0.04}, area), Place::top);
    EXPECT_EQ(place_of({0.05, 0.04}, area), Place::upper_right);
    EXPECT_EQ(place_of({-0.05, 0.0}, area), Place::left);
    EXPECT_EQ(place_of({0.0, 0.0}, area), Place::middle);
    EXPECT_EQ(place_of({0.5, 0.0}, area), Place::right);
    EXPECT_EQ(place_of({-0.05, -0.04}, area), Place::lower_left);
    EXPECT_EQ(place_of({0.0, -0.04}, area), Place::bottom);
    EXPECT_EQ(place_of({0.05, -0.04}, area), Place::lower_right);
}

TEST(Guidance, ATwistHumsOnItsSideHigherAndLouderTheStrongerItIs) {
    const ContinuousTone left = torque_tone(4e-3);
    const ContinuousTone right = torque_tone(-8e-3);
    EXPECT_LT(left.pan, -0.5);
    EXPECT_GT(right.pan, 0.5);
    EXPECT_GT(right.level, left.level);
    EXPECT_GT(right.frequency_Hz, left.frequency_Hz);
    EXPECT_EQ(torque_tone(strong_Nm).frequency_Hz, torque_tone(1.0).frequency_Hz);
    for (const double quiet : {0.0, 1e-3, -1e-3, none, infinite})
        EXPECT_EQ(torque_tone(quiet).level, 0.0) << quiet;
}

TEST(Guidance, ATwistGoesBeforeTheDistanceAndAfterATarget) {
    ContinuousChoice choice;
    choice.torque_Nm = 5e-3;
    const CueArea area;
    const double hum_Hz = torque_tone(5e-3).frequency_Hz;
    EXPECT_EQ(continuous_tone(choice, {}, 0.0, area).frequency_Hz, hum_Hz);
    choice.amount = CueAmount::full;
    EXPECT_EQ(continuous_tone(choice, {}, 0.005, area).frequency_Hz, hum_Hz);
    choice.target_W = Position{0.02, 0.0};
    EXPECT_NE(continuous_tone(choice, {}, 0.005, area).frequency_Hz, hum_Hz);
    choice = {CueAmount::none, false, std::nullopt, 5e-3};
    EXPECT_EQ(continuous_tone(choice, {}, 0.005, area).level, 0.0);
}

}  // namespace
}  // namespace touchline
