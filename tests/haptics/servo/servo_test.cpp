#include "haptics/servo/servo.h"

#include "haptics/device/simulated/simulated_pantograph.h"
#include "tests/haptics/servo/rigs.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <thread>
#include <utility>

#include <gtest/gtest.h>

namespace touchline {
namespace {

ServoOptions plain_thread(std::size_t recorded_ticks = 0) {
    ServoOptions options;
    options.is_real_time = false;
    options.recorded_ticks = recorded_ticks;
    return options;
}

std::unique_ptr<ForceDevice> simulated(std::shared_ptr<const IntendedPath> path) {
    return std::make_unique<SimulatedPantograph>(default_profile(), SimulationOptions{},
                                                 std::move(path));
}

std::unique_ptr<ForceDevice> simulated_at_rest() {
    return simulated(std::make_shared<MouseHand>(Position{}));
}

/// Remembers its last torques beyond its own life.
class WitnessedDevice final : public ForceDevice {
  public:
    WitnessedDevice(std::unique_ptr<ForceDevice> inner, JointTorques& last, bool& is_gone)
        : inner_(std::move(inner)), last_(last), is_gone_(is_gone) {}

    ~WitnessedDevice() override { is_gone_ = true; }

    [[nodiscard]] std::optional<DeviceReading> read(double now_s) override {
        return inner_->read(now_s);
    }

    [[nodiscard]] bool write(const DeviceCommand& command) override {
        last_ = command.torques;
        return inner_->write(command);
    }

  private:
    std::unique_ptr<ForceDevice> inner_;
    JointTorques& last_;
    bool& is_gone_;
};

template <class Condition>
void wait_until(Condition&& condition) {
    while (!condition()) std::this_thread::yield();
}

TEST(Servo, RunsAndReports) {
    Servo servo;
    EXPECT_EQ(servo.latest().ticks, 0U);
    ASSERT_TRUE(servo.start(simulated_at_rest(), default_profile(), plain_thread()).has_value());
    wait_until([&] { return servo.latest().ticks >= 20; });
    EXPECT_EQ(servo.force_status().fault, Fault::none);
    EXPECT_NEAR(norm(servo.latest().p_WH), 0.0, 1e-3);
    servo.stop();
}

TEST(Servo, StartingTwiceIsAnError) {
    Servo servo;
    ASSERT_TRUE(servo.start(simulated_at_rest(), default_profile(), plain_thread()).has_value());
    const auto again = servo.start(simulated_at_rest(), default_profile(), plain_thread());
    ASSERT_FALSE(again.has_value());
    EXPECT_EQ(again.error().line, "the servo runs already; stop it before giving it a device");
}

TEST(Servo, PeriodMustMakeSense) {
    for (const double period_s : {0.0, -1.0, 2.0, std::numeric_limits<double>::quiet_NaN()}) {
        Servo servo;
        ServoOptions options = plain_thread();
        options.period_s = period_s;
        EXPECT_FALSE(servo.start(simulated_at_rest(), default_profile(), options).has_value());
    }
}

TEST(Servo, StopsWithZeroTorqueAndGivesTheDeviceUp) {
    JointTorques last{1.0, 1.0};
    bool is_gone = false;
    Servo servo;
    servo.feel(line_scene(0.0));
    const auto mouse = std::make_shared<MouseHand>(Position{0.0, 0.005});
    ASSERT_TRUE(servo
                    .start(std::make_unique<WitnessedDevice>(simulated(mouse), last, is_gone),
                           default_profile(), plain_thread())
                    .has_value());
    wait_until([&] { return servo.force_status().state == ForceState::live; });
    mouse->move_to({0.0, -0.01});
    wait_until([&] { return norm(servo.latest().force) > 0.2; });
    EXPECT_EQ(servo.latest().state, ContactState::edge);
    servo.stop();
    EXPECT_EQ(last, JointTorques{});
    EXPECT_TRUE(is_gone);
    EXPECT_EQ(servo.latest().force, Force{});
    servo.stop();  // a second time does nothing
}

TEST(Servo, DestructorStops) {
    JointTorques last{1.0, 1.0};
    bool is_gone = false;
    {
        Servo servo;
        ASSERT_TRUE(
            servo
                .start(std::make_unique<WitnessedDevice>(simulated_at_rest(), last, is_gone),
                       default_profile(), plain_thread())
                .has_value());
    }
    EXPECT_TRUE(is_gone);
    EXPECT_EQ(last, JointTorques{});
}

TEST(Servo, TakesCommandsAndScenesWhileItRuns) {
    Servo servo;
    ASSERT_TRUE(servo.start(simulated_at_rest(), default_profile(), plain_thread(100)).has_value());
    ServoCommands commands;
    commands.is_level_auto = false;
    commands.level = 2.0;
    for (std::uint64_t version = 1; version <= 5; ++version) {
        servo.feel(line_scene(0.02, version));
        servo.set(commands);
        wait_until([&] { return servo.latest().map_version == version; });
    }
    EXPECT_FALSE(servo.latest().is_level_auto);
    EXPECT_EQ(servo.latest().level_terms.finest, 2.0);
    wait_until([&] { return servo.latest().ticks >= 100; });
    servo.stop();
    EXPECT_EQ(servo.recording().ticks().size(), 100U);
}

TEST(Servo, CanBeStartedAgainWithWhatItWasTold) {
    Servo servo;
    servo.feel(line_scene(0.02, 7));
    for (int round = 0; round < 2; ++round) {
        ASSERT_TRUE(
            servo.start(simulated_at_rest(), default_profile(), plain_thread()).has_value());
        wait_until([&] { return servo.latest().ticks >= 5 && servo.latest().map_version == 7; });
        servo.stop();
    }
}

TEST(Servo, RealTimeIsGrantedOrRefusedButNeverFails) {
    Servo servo;
    EXPECT_EQ(servo.tier(), std::nullopt);
    ASSERT_TRUE(servo.start(simulated_at_rest(), default_profile(), ServoOptions{}).has_value());
    wait_until([&] { return servo.latest().ticks >= 5; });
    ASSERT_TRUE(servo.tier().has_value());
    EXPECT_FALSE(describe(*servo.tier()).empty());
    servo.stop();
}

/// This thread reads while the loop goes on in its own.
TEST(Servo, ItsRecordingCanBeHeldAndReadWhileItRuns) {
    Servo servo;
    ASSERT_TRUE(servo.start(simulated_at_rest(), default_profile(), plain_thread(500)).has_value());
    for (int i = 0; i < 3; ++i) {
        wait_until([&] { return servo.latest().ticks > static_cast<std::uint64_t>(50 * (i + 1)); });
        servo.recording().hold();
        wait_until([&] { return servo.recording().is_held(); });
        const auto ticks = servo.recording().ticks();
        ASSERT_GT(ticks.size(), 1U);
        for (std::size_t k = 1; k < ticks.size(); ++k)
            ASSERT_GT(ticks[k].time_s, ticks[k - 1].time_s);
        EXPECT_EQ(servo.recording().start()->tick, 0U);
        servo.recording().release();
        wait_until([&] { return !servo.recording().is_held(); });
    }
}

}  // namespace
}  // namespace touchline
