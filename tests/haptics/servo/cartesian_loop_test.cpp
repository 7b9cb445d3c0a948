// The whole loop on a device without links, which tells places and takes forces: the same walls,
// the same limits, the same faults as with a five-bar; and a third axis.
#include "haptics/device/simulated/simulated_cartesian.h"
#include "haptics/servo/recording.h"
#include "haptics/servo/servo_loop.h"
#include "tests/haptics/servo/rigs.h"
#include "tests/haptics/tick.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include <gtest/gtest.h>

namespace touchline {
namespace {

const DeviceProfile& profile() {
    return cartesian_profiles().front();
}

/// Between the loop and the device: what it told may be changed or lost.
class Spoiled final : public ForceDevice {
  public:
    explicit Spoiled(ForceDevice& behind) : behind_(behind) {}

    [[nodiscard]] std::optional<DeviceReading> read(double now_s) override {
        auto told = behind_.read(now_s);
        if (is_silent) return std::nullopt;
        if (told) told->p_D = *told->p_D + leap;
        if (told) told->off_plane->m_per_s += across_m_per_s;
        if (told && velocity_factor != 1.0) told->velocity_D = velocity_factor * *told->velocity_D;
        return told;
    }

    [[nodiscard]] bool write(const DeviceCommand& command) override {
        written = command;
        return behind_.write(command);
    }

    bool is_silent = false;
    Position leap;
    double across_m_per_s = 0.0;
    double velocity_factor = 1.0;
    DeviceCommand written;

  private:
    ForceDevice& behind_;
};

/// A loop on a simulated device; the hand is led by the test.
struct Bench3 {
    std::shared_ptr<MouseHand> hand = std::make_shared<MouseHand>(Position{0.0, 0.01});
    std::shared_ptr<MouseHand> across = std::make_shared<MouseHand>(Position{});
    SimulatedCartesian device{profile(), {}, hand, across};
    Spoiled line{device};
    ServoExchange exchange;
    Recorder recorder{20'000};
    ServoLoop loop{line, profile(), tick_s, exchange, recorder};
    int ticks = 0;
    double most_N = 0.0;

    Bench3() {
        exchange.feel(line_scene(0.0));
        run(1.5);
        EXPECT_EQ(report().force.state, ForceState::live);
    }

    const ServoReport& report() { return exchange.report(); }

    void run(double span_s) {
        for (const int end = ticks + static_cast<int>(std::lround(span_s / tick_s)); ticks < end;) {
            loop.tick(tick_s * ticks++, 0);
            most_N = std::max(
                most_N, std::hypot(norm(device.acting().in_plane_D), device.acting().across_N));
            ASSERT_EQ(line.written.torques, JointTorques{});
        }
    }

    void move(Position to, double span_s) {
        const Position from = at_;
        const int steps = static_cast<int>(std::lround(span_s / tick_s));
        for (int i = 1; i <= steps; ++i) {
            hand->move_to(from + static_cast<double>(i) / steps * (to - from));
            run(tick_s);
        }
        at_ = to;
    }

  private:
    Position at_{0.0, 0.01};
};

TEST(CartesianLoop, AWallHoldsTheHand) {
    Bench3 bench;
    bench.move({0.0, -0.006}, 0.3);
    bench.run(0.5);
    const HandState hand = bench.report().hand;
    EXPECT_EQ(hand.state, ContactState::edge);
    EXPECT_NEAR(hand.p_WP.y, 0.0, 1e-9) << "the proxy stays on the line";
    EXPECT_GT(hand.force.y, 0.5);
    EXPECT_NEAR(hand.force.x, 0.0, 1e-6);
    EXPECT_EQ(bench.line.written.force_D, turned(hand.force));
    EXPECT_NEAR(bench.device.acting().in_plane_D.y, -hand.force.y, 1e-3);
    // The wall's spring and the hand's share the way between the line and where the hand means to
    // be.
    const double depth_m = -bench.device.tip().position.y;
    EXPECT_NEAR(hand.force.y, normal_hand.stiffness_N_per_m * (0.006 - depth_m), 0.12);
    EXPECT_LE(bench.most_N, profile().force_limit_N);
}

TEST(CartesianLoop, AHandThatPushesHardMeetsTheForceLimit) {
    Bench3 bench;
    bench.move({0.0, -0.05}, 1.0);
    bench.run(0.2);
    EXPECT_LE(norm(bench.report().hand.force), profile().force_limit_N * (1.0 + 1e-12));
    EXPECT_GT(bench.most_N, 0.9 * profile().force_limit_N);
    EXPECT_LE(bench.most_N, profile().force_limit_N * (1.0 + 1e-12));
}

TEST(CartesianLoop, AHandSlipsAlongAWall) {
    Bench3 bench;
    bench.move({-0.03, -0.004}, 0.5);
    bench.run(0.3);
    for (int i = 0; i < 30; ++i) {
        bench.move({-0.03 + 0.002 * i, -0.004}, 0.02);
        EXPECT_NEAR(bench.report().hand.p_WP.y, 0.0, 1e-9);
        EXPECT_NEAR(bench.report().hand.force.x, 0.0, 1e-6) << "nothing holds it back";
    }
    EXPECT_GT(bench.device.tip().position.x, 0.02);
}

TEST(CartesianLoop, ASilentDeviceGetsNoForceAtOnceAndIsLostAfterTwentyMilliseconds) {
    Bench3 bench;
    bench.move({0.0, -0.004}, 0.3);
    ASSERT_GT(norm(bench.line.written.force_D), 0.3);
    ASSERT_GT(bench.line.written.plane_share, 0.9);
    bench.line.is_silent = true;
    bench.run(tick_s);
    EXPECT_EQ(bench.line.written, DeviceCommand{});
    bench.run(0.021);
    EXPECT_EQ(bench.report().force.fault, Fault::device_lost);
    bench.move({0.0, 0.01}, 0.3);
    bench.line.is_silent = false;
    bench.run(1.5);
    EXPECT_EQ(bench.report().force.state, ForceState::live) << "by the rule of arming";
}

TEST(CartesianLoop, AJumpIsNotBelievedAtOnceAndThenIsAFault) {
    Bench3 bench;
    bench.line.leap = {0.02, 0.0};
    bench.run(3.0 * tick_s);
    EXPECT_EQ(bench.report().force.fault, Fault::none);
    bench.run(2.0 * tick_s);
    EXPECT_EQ(bench.report().force.fault, Fault::position_jump);
    EXPECT_EQ(bench.line.written, DeviceCommand{});
}

TEST(CartesianLoop, ANumberThatIsNoneIsAFaultInTheSameTick) {
    for (const bool is_velocity : {false, true}) {
        Bench3 bench;
        bench.move({0.0, -0.004}, 0.3);
        if (is_velocity) bench.line.velocity_factor = std::numeric_limits<double>::quiet_NaN();
        if (!is_velocity) bench.line.leap.y = std::numeric_limits<double>::infinity();
        for (int i = 0; i < 10; ++i) {
            bench.run(tick_s);
            EXPECT_EQ(bench.report().force.fault, Fault::not_finite);
            EXPECT_EQ(bench.line.written, DeviceCommand{});
            EXPECT_TRUE(is_finite(bench.report().hand.p_WH) && is_finite(bench.report().hand.p_WP));
        }
        bench.line.velocity_factor = 1.0;
        bench.line.leap = {};
        ServoCommands commands;
        commands.faults_cleared = 1;
        bench.exchange.set(commands);
        bench.run(0.1);
        EXPECT_EQ(bench.report().force.fault, Fault::none) << "nothing of it stays";
        EXPECT_TRUE(std::isfinite(bench.report().hand.speed_m_per_s));
    }
}

TEST(CartesianLoop, OffThePlaneNothingInItIsFeltAndTheSpringLeadsBack) {
    Bench3 bench;
    bench.move({0.0, -0.004}, 0.3);
    bench.across->move_to({0.02, 0.0});
    bench.run(0.5);
    ASSERT_GT(bench.device.off_m(), profile().cartesian->spring.off_plane_m);
    EXPECT_EQ(bench.device.acting().in_plane_D, Force{});
    EXPECT_EQ(bench.line.written.force_D, Force{}) << "nor does the chain believe in one";
    EXPECT_DOUBLE_EQ(bench.device.acting().across_N, -profile().cartesian->spring.most_N);
    bench.across->move_to({});
    bench.run(0.5);
    EXPECT_LT(std::abs(bench.device.off_m()), 1e-3);
    EXPECT_GT(norm(bench.device.acting().in_plane_D), 0.3);
    EXPECT_LE(bench.most_N, profile().force_limit_N * (1.0 + 1e-12));
}

TEST(CartesianLoop, ComingDownBehindALineTheForceRisesByItsSlew) {
    Bench3 bench;
    bench.across->move_to({0.02, 0.0});
    bench.run(0.5);
    bench.move({0.0, -0.02}, 0.3);
    bench.across->move_to({-0.02, 0.0});  // fast
    double before_N = 0.0;
    for (int i = 0; i < 200; ++i) {
        bench.run(tick_s);
        const double now_N = norm(bench.line.written.force_D);
        ASSERT_LE(now_N, before_N + 300.0 * tick_s + 1e-9);
        before_N = now_N;
    }
}

TEST(CartesianLoop, ASpeedAcrossThePlaneIsASpeedOfTheHand) {
    Bench3 bench;
    bench.move({0.0, -0.004}, 0.3);
    bench.line.across_m_per_s = -1.6;
    bench.run(2.0 * tick_s);
    EXPECT_EQ(bench.report().force.fault, Fault::too_fast);
    EXPECT_EQ(bench.line.written, DeviceCommand{}) << "the plane lets go too";
    Bench3 unsound;
    unsound.line.across_m_per_s = std::numeric_limits<double>::quiet_NaN();
    unsound.run(tick_s);
    EXPECT_EQ(unsound.report().force.fault, Fault::not_finite);
}

TEST(CartesianLoop, NothingHoldsTheHandleToThePlaneBeforeForceIsArmed) {
    const auto hand = std::make_shared<MouseHand>(Position{0.0, 0.01});
    const auto across = std::make_shared<MouseHand>(Position{0.02, 0.0});
    SimulatedCartesian device(profile(), {}, hand, across);
    ServoExchange exchange;
    Recorder recorder;
    ServoLoop loop(device, profile(), tick_s, exchange, recorder);
    double before = 0.0;
    for (int i = 0; i < 1500; ++i) {
        loop.tick(tick_s * i, 0);
        const ForceState state = exchange.report().force.state;
        const bool is_armed = state == ForceState::ramp || state == ForceState::live;
        ASSERT_TRUE(is_armed || device.acting().across_N == 0.0);
        ASSERT_LT(std::abs(device.acting().across_N - before), 0.01) << "it comes slowly";
        before = device.acting().across_N;
    }
    EXPECT_DOUBLE_EQ(before, -profile().cartesian->spring.most_N);
}

TEST(CartesianLoop, AnEmergencyStopLetsGoOfThePlaneToo) {
    Bench3 bench;
    bench.move({0.0, -0.004}, 0.3);
    ServoCommands commands;
    commands.is_emergency_stop = true;
    bench.exchange.set(commands);
    bench.run(tick_s);
    EXPECT_EQ(bench.line.written, DeviceCommand{});
}

TEST(CartesianLoop, ItsRecordingRunsAgainBitForBit) {
    Bench3 bench;
    bench.move({0.0, -0.004}, 0.3);
    bench.move({0.03, -0.002}, 0.3);
    bench.recorder.hold();
    bench.run(tick_s);
    ASSERT_TRUE(bench.recorder.is_held());
    const Recording kept = make_recording(bench.recorder, std::string(profile().name),
                                          {RecordedMap{1, "line.svg", 3, 0}});
    const auto read = recording_of(bytes_of(kept));
    ASSERT_TRUE(read.has_value());
    const auto scene = line_scene(0.0);
    const auto replay = run_again(
        *read, [&](std::uint64_t) { return Result<std::shared_ptr<const Scene>>(scene); });
    ASSERT_TRUE(replay.has_value());
    EXPECT_GT(replay->ticks.size(), 2000U);
    EXPECT_FALSE(replay->differs_at.has_value());
}

}  // namespace
}  // namespace touchline
