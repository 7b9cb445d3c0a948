// The nudge test on the simulated pantograph, with motors that are off, reversed and swapped.
#include "haptics/device/nudge_test.h"

#include "haptics/device/simulated/simulated_pantograph.h"
#include "tests/haptics/tick.h"

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

struct Wiring {
    std::function<JointTorques(JointTorques)> torques = [](JointTorques t) { return t; };
    std::function<JointAngles(JointAngles)> angles = [](JointAngles a) { return a; };
};

NudgeVerdict nudge(const Wiring& wiring, const HandModel& hand = no_hand,
                   const DeviceProfile& profile = default_profile()) {
    SimulationOptions options;
    options.hand = hand;
    SimulatedPantograph device(
        profile, options,
        std::make_shared<WaypointPath>(std::vector<WaypointPath::Waypoint>{{0.0, {0.0, 0.0}}}));
    NudgeTest test(encoder_quantum(profile));
    for (int k = 0; k < 5000 && test.verdict() == NudgeVerdict::running; ++k) {
        const JointTorques torques =
            test.step(wiring.angles(device.read_angles(k * tick_s).value()), tick_s);
        EXPECT_LE(std::abs(torques.x), 0.03);
        EXPECT_LE(std::abs(torques.y), 0.03);
        EXPECT_TRUE(torques.x == 0.0 || torques.y == 0.0);
        EXPECT_TRUE(device.write_torques(wiring.torques(torques)));
    }
    return test.verdict();
}

TEST(NudgeTest, EveryProfileWorks) {
    for (const DeviceProfile& profile : device_profiles())
        EXPECT_EQ(nudge({}, no_hand, profile), NudgeVerdict::works) << profile.name;
}

TEST(NudgeTest, WorksUnderALightHand) {
    EXPECT_EQ(nudge({}, light_hand), NudgeVerdict::works);
}

TEST(NudgeTest, KnowsMotorsWithoutPower) {
    const auto off = [](double one, double two) {
        return Wiring{[=](JointTorques t) { return JointTorques{one * t.x, two * t.y}; }};
    };
    EXPECT_EQ(nudge(off(0.0, 0.0)), NudgeVerdict::no_power);
    EXPECT_EQ(nudge(off(0.0, 1.0)), NudgeVerdict::motor_1_off);
    EXPECT_EQ(nudge(off(1.0, 0.0)), NudgeVerdict::motor_2_off);
    EXPECT_EQ(nudge(off(-1.0, -1.0)), NudgeVerdict::reversed_both);
    EXPECT_EQ(nudge(off(-1.0, 1.0)), NudgeVerdict::reversed_1);
    EXPECT_EQ(nudge(off(1.0, -1.0)), NudgeVerdict::reversed_2);
}

TEST(NudgeTest, KnowsSwappedPlugs) {
    EXPECT_EQ(nudge({[](JointTorques t) {
                  return JointTorques{t.y, t.x};
              }}),
              NudgeVerdict::swapped);
    Wiring encoders;
    encoders.angles = [](JointAngles a) { return JointAngles{a.y, a.x}; };
    EXPECT_EQ(nudge(encoders), NudgeVerdict::swapped);
}

TEST(NudgeTest, AHandleThatMovesIsNotJudged) {
    double turn = 0.0;
    Wiring moving;
    moving.angles = [&turn](JointAngles a) { return a + JointAngles{turn += 2e-3, 0.0}; };
    EXPECT_EQ(nudge(moving), NudgeVerdict::restless);
}

TEST(NudgeTest, ASilentBoardOrNoNumberEndsWithZeroTorque) {
    for (const std::optional<JointAngles>& angles :
         {std::optional<JointAngles>{}, std::optional<JointAngles>{{std::nan(""), 0.0}}}) {
        NudgeTest test({1e-3, 1e-3});
        for (int k = 0; k < 100; ++k) EXPECT_EQ(test.step(angles, tick_s), JointTorques{});
        EXPECT_EQ(test.verdict(), NudgeVerdict::silent);
    }
}

}  // namespace
}  // namespace touchline
