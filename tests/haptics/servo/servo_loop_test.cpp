#include "haptics/servo/servo_loop.h"

#include "haptics/device/simulated/simulated_pantograph.h"
#include "tests/haptics/servo/rigs.h"
#include "tests/haptics/tick.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr std::int64_t period_ns = 1'000'000;

/// A clock that asks the loop to end at a given moment.
class EndingClock final : public Clock {
  public:
    EndingClock(std::int64_t end_ns, LoopEnd& end) : end_ns_(end_ns), end_(end) {}

    [[nodiscard]] std::int64_t now_ns() override { return time_.now_ns(); }

    void sleep_until(std::int64_t t_ns) override {
        time_.sleep_until(t_ns);
        if (t_ns >= end_ns_) end_.is_wanted = true;
    }

    VirtualClock& time() { return time_; }

  private:
    VirtualClock time_;
    std::int64_t end_ns_;
    LoopEnd& end_;
};

std::vector<TickRecord> explore_in_simulation() {
    const auto path = std::make_shared<WaypointPath>(std::vector<WaypointPath::Waypoint>{
        {0.0, {-0.03, 0.02}}, {1.0, {-0.03, 0.02}}, {1.3, {-0.03, -0.005}}, {2.3, {0.03, -0.005}}});
    SimulatedPantograph device(default_profile(), {}, path);
    ServoExchange exchange;
    exchange.feel(line_scene(0.0));
    Recorder recorder(3000);
    ServoLoop loop(device, default_profile(), tick_s, exchange, recorder);
    LoopEnd end;
    EndingClock clock(2'300 * period_ns, end);
    loop.run(clock, period_ns, end);
    (void)device.read_angles(3.0);  // the last write has arrived
    EXPECT_EQ(device.acting_torques(), JointTorques{});
    return recorder.ticks();
}

TEST(ServoLoop, SimulatedHandSlidesAlongTheWallAndNeverThroughIt) {
    const auto ticks = explore_in_simulation();
    ASSERT_GE(ticks.size(), 2301U);
    double most_N = 0.0;
    for (const TickRecord& tick : ticks) {
        EXPECT_GE(tick.p_WP.y, 0.0);
        most_N = std::max(most_N, norm(tick.force));
    }
    // The hand (300 N/m) aims 5 mm beyond a wall of 500 N/m.
    const TickRecord& sliding = ticks[2200];
    EXPECT_EQ(sliding.state, ContactState::edge);
    EXPECT_NEAR(sliding.force.y, 0.94, 0.15);
    EXPECT_NEAR(sliding.p_WH.y, -0.0019, 0.0004);
    EXPECT_GT(sliding.p_WP.x, 0.01);
    EXPECT_LT(most_N, 1.7);
}

TEST(ServoLoop, SameRunGivesTheSameBits) {
    const auto a = explore_in_simulation();
    const auto b = explore_in_simulation();
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        ASSERT_EQ(a[i].p_WH, b[i].p_WH);
        ASSERT_EQ(a[i].p_WP, b[i].p_WP);
        ASSERT_EQ(a[i].force, b[i].force);
    }
}

TEST(ServoLoop, EventsReachTheOtherSideInOrder) {
    PlacedDevice device({0.0, 0.01});
    ServoExchange exchange;
    exchange.feel(line_scene(0.0));
    ServoCommands commands;
    commands.contact.mode = Mode::groove;
    exchange.set(commands);
    Recorder recorder;
    ServoLoop loop(device, default_profile(), tick_s, exchange, recorder);
    for (int k = 0; k < 1000; ++k) {
        device.angles = angles_at(default_profile(), {0.0, 0.01 - 2e-5 * k});
        loop.tick(k * tick_s, 0);
    }
    double last_s = 0.0;
    for (const ContactEventKind kind :
         {ContactEventKind::contact_made, ContactEventKind::line_crossed,
          ContactEventKind::contact_lost}) {
        const auto event = exchange.next_event();
        ASSERT_TRUE(event.has_value());
        EXPECT_EQ(event->kind, kind);
        EXPECT_GE(event->time_s, last_s);
        last_s = event->time_s;
    }
    EXPECT_FALSE(exchange.next_event().has_value());
    EXPECT_EQ(exchange.dropped_events(), 0U);
}

TEST(ServoLoop, LateTicksAreSkippedCountedAndPublished) {
    PlacedDevice device({0.0, 0.0});
    ServoExchange exchange;
    Recorder recorder(1000);
    ServoLoop loop(device, default_profile(), tick_s, exchange, recorder);
    LoopEnd end;
    EndingClock clock(100 * period_ns, end);
    clock.time().work_ns = 2'500'000;  // every tick takes two and a half periods
    loop.run(clock, period_ns, end);
    const HandState& hand = exchange.report().hand;
    EXPECT_GT(hand.missed_ticks, 40U);
    const auto ticks = recorder.ticks();
    EXPECT_NEAR(static_cast<double>(ticks.size() + hand.missed_ticks), 101.0, 2.0);
    for (std::size_t i = 1; i < ticks.size(); ++i) {
        EXPECT_GE(ticks[i].time_s - ticks[i - 1].time_s, 1e-3 - 1e-12);
    }
}

/// Presses through the line y = 0 until it pushes with a newton.
void press(ServoLoop& loop, PlacedDevice& device) {
    for (int k = 0; k < 800; ++k) loop.tick(k * tick_s, 0);
    for (int k = 800; k < 900; ++k) {
        const double y_m = std::max(-0.002, 0.01 - 2e-4 * (k - 800));
        device.angles = angles_at(default_profile(), {0.0, y_m});
        loop.tick(k * tick_s, 0);
    }
    ASSERT_NE(device.written, JointTorques{});
}

TEST(ServoLoop, StopFadesOutThenWritesZero) {
    PlacedDevice device({0.0, 0.01});
    ServoExchange exchange;
    exchange.feel(line_scene(0.0));
    Recorder recorder(1000);
    ServoLoop loop(device, default_profile(), tick_s, exchange, recorder);
    press(loop, device);
    ASSERT_NEAR(norm(exchange.report().hand.force), 1.0, 0.02);
    LoopEnd end;
    end.is_wanted = true;
    VirtualClock clock;
    loop.run(clock, period_ns, end);
    EXPECT_EQ(device.written, JointTorques{});
    EXPECT_LE(clock.now_ns(), 52 * period_ns);
}

TEST(ServoLoop, DeviceThatTakesNoTorquesIsAFault) {
    PlacedDevice device({0.0, 0.01});
    ServoExchange exchange;
    exchange.feel(line_scene(0.0));
    Recorder recorder(2);
    ServoLoop loop(device, default_profile(), tick_s, exchange, recorder);
    press(loop, device);
    device.is_listening = false;
    loop.tick(0.9, 0);
    EXPECT_TRUE(recorder.ticks().back().is_refused);
    loop.tick(0.9 + tick_s, 0);
    EXPECT_EQ(exchange.report().force.fault, Fault::device_lost);
    EXPECT_EQ(device.written, JointTorques{});
    EXPECT_FALSE(recorder.ticks().back().is_refused) << "a zero that was only sent is no refusal";
}

/// A loop that ended must show whether there may still be torque.
TEST(ServoLoop, ItsLastZeroIsWrittenUntilTheDeviceHoldsIt) {
    for (const int zeros_until_held : {1, 3, 1000}) {
        PlacedDevice device({0.0, 0.01});
        ServoExchange exchange;
        exchange.feel(line_scene(0.0));
        Recorder recorder(2);
        ServoLoop loop(device, default_profile(), tick_s, exchange, recorder);
        press(loop, device);
        device.zeros_until_held = zeros_until_held;
        LoopEnd end;
        end.is_cut = true;
        VirtualClock clock;
        loop.run(clock, period_ns, end);
        EXPECT_EQ(device.written, JointTorques{});
        EXPECT_EQ(exchange.channel().is_force_on, zeros_until_held == 1000 ? 1 : 0);
        EXPECT_LE(clock.now_ns(), 21 * period_ns);
    }
}

}  // namespace
}  // namespace touchline
