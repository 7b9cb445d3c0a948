// A loop that rests while nobody is here, on a virtual clock: how seldom it ticks, how soon it is
// awake, and that a rest changes nothing else.
#include "haptics/servo/handle_rest.h"

#include "haptics/servo/recording.h"
#include "haptics/servo/servo_loop.h"
#include "tests/haptics/servo/rigs.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr std::int64_t loop_period_ns = 1'000'000;
constexpr double rested_s = HandleRest::least_s + 1.0;
constexpr Position standing_place{0.01, 0.02};

/// Calls back before each tick, which begins as many nanoseconds late as that says.
class WatchedClock final : public Clock {
  public:
    explicit WatchedClock(std::function<std::int64_t(double)> before_tick)
        : before_tick_(std::move(before_tick)) {}

    [[nodiscard]] std::int64_t now_ns() override { return time_ns_; }

    void sleep_until(std::int64_t t_ns) override {
        time_ns_ = std::max(time_ns_, t_ns);
        time_ns_ += before_tick_(1e-9 * static_cast<double>(time_ns_));
    }

  private:
    std::function<std::int64_t(double)> before_tick_;
    std::int64_t time_ns_ = 0;
};

/// A loop with a device that stands still, and commands of a kiosk where nobody is.
class RestingRun {
  public:
    explicit RestingRun(double motor_heat = 0.0) {
        rules_.granted = RealTimeTier::fifo;
        rules_.has_motors = true;
        rules_.motor_heat = motor_heat;
        commands.may_rest = true;
        commands.is_force_wanted = false;
        exchange.feel(line_scene(0.0));
        exchange.set(commands);
    }

    /// Calls `script` before each tick with the time.
    void go(double until_s, const std::function<void(double)>& script = {}) {
        ServoLoop loop(device, default_profile(), 1e-9 * static_cast<double>(loop_period_ns),
                       exchange, recorder, rules_);
        WatchedClock clock([&](double now_s) {
            ticks_s.push_back(now_s);
            if (script) script(now_s);
            if (now_s >= until_s) end_.is_cut = true;
            return now_s >= late_at_s ? std::exchange(late_ns, 0) : 0;
        });
        loop.run(clock, loop_period_ns, end_);
    }

    /// Returns the longest time between ticks from `from_s` on.
    [[nodiscard]] double longest_gap_s(double from_s) const {
        double longest_s = 0.0;
        for (std::size_t i = 1; i < ticks_s.size(); ++i)
            if (ticks_s[i - 1] >= from_s)
                longest_s = std::max(longest_s, ticks_s[i] - ticks_s[i - 1]);
        return longest_s;
    }

    [[nodiscard]] std::size_t ticks_between(double from_s, double to_s) const {
        return static_cast<std::size_t>(std::ranges::count_if(
            ticks_s, [&](double at_s) { return at_s >= from_s && at_s < to_s; }));
    }

    ServoCommands commands;
    ServoExchange exchange;
    PlacedDevice device{standing_place};
    Recorder recorder{40'000};
    std::vector<double> ticks_s;
    double late_at_s = 0.0;  // from then on one tick begins late_ns late
    std::int64_t late_ns = 0;

  private:
    LoopRules rules_;
    LoopEnd end_;
};

TEST(HandleRest, LoopTicksEveryEightMillisecondsWhileNobodyIsHere) {
    RestingRun run;
    run.go(rested_s + 10.0);
    EXPECT_EQ(run.ticks_between(1.0, 2.0), 1000U);
    EXPECT_EQ(run.ticks_between(rested_s, rested_s + 10.0), 1250U);
    EXPECT_EQ(run.exchange.report().hand.missed_ticks, 0U);
}

TEST(HandleRest, HandThatComesIsSeenWithinEightMillisecondsAndThenInEveryTick) {
    for (const double begins_s : {rested_s, rested_s + 0.0011, rested_s + 0.0079}) {
        RestingRun run;
        double seen_s = 0.0;
        run.go(rested_s + 1.0, [&](double now_s) {
            // A quick hand: 10 m/s^2 from a standstill.
            const double for_s = std::clamp(now_s - begins_s, 0.0, 0.05);
            const Position place = standing_place + Position{5.0 * for_s * for_s, 0.0};
            run.device.angles = angles_at(default_profile(), place);
            if (for_s > 0.0 && seen_s == 0.0) seen_s = now_s;
        });
        EXPECT_LE(seen_s - begins_s, 0.0081);
        EXPECT_LE(run.longest_gap_s(begins_s + 0.0161), 0.0011) << "awake after two ticks";
    }
}

TEST(HandleRest, ForceThatIsWantedEndsTheRestAndComesAsEver) {
    RestingRun run;
    double live_s = 0.0;
    run.go(rested_s + 2.0, [&](double now_s) {
        // Sways a little, because a hand that rests counts as let go.
        const double sway_m = now_s < rested_s ? 0.0 : 1e-3 * std::sin(6.0 * (now_s - rested_s));
        run.device.angles = angles_at(default_profile(), standing_place + Position{sway_m, 0.0});
        if (now_s >= rested_s && !run.commands.is_force_wanted) {
            run.commands.is_force_wanted = true;
            run.commands.may_rest = false;
            run.exchange.set(run.commands);
        }
        const ForceState state = run.exchange.report().force.state;
        if (state == ForceState::live && live_s == 0.0) live_s = now_s;
    });
    EXPECT_LE(run.longest_gap_s(rested_s + 0.0081), 0.0011);
    // Armed for 0.2 s, then a ramp of 0.5 s.
    EXPECT_GT(live_s, rested_s + 0.7);
    EXPECT_LT(live_s, rested_s + 0.72);
}

TEST(HandleRest, NoRestWhileSomebodyIsHereOrForceIsWantedOrTheDeviceIsSilent) {
    for (int reason = 0; reason < 3; ++reason) {
        RestingRun run;
        if (reason == 0) run.commands.may_rest = false;
        if (reason == 1) run.commands.is_force_wanted = true;
        if (reason == 2) run.device.angles.reset();
        run.exchange.set(run.commands);
        run.go(rested_s + 1.0);
        EXPECT_LE(run.longest_gap_s(0.0), 0.0011) << reason;
    }
}

TEST(HandleRest, ChangesNeitherTierNorStiffnessNorHowMotorsCool) {
    constexpr double heat = 0.5;
    constexpr double warming_s = 60.0;
    RestingRun run(heat);
    run.go(1.0);
    const StiffnessBound before = run.exchange.report().hand.stiffness_bound;
    RestingRun rested(heat);
    rested.late_at_s = rested_s + 30.0;
    rested.late_ns = 5 * loop_period_ns;
    rested.go(rested_s + warming_s);
    EXPECT_EQ(rested.exchange.report().hand.stiffness_bound.most_N_per_m, before.most_N_per_m);
    EXPECT_EQ(tier_of(rested.exchange.channel()), RealTimeTier::fifo);
    const double cooled = heat * std::exp(-(rested_s + warming_s) / warming_s);
    EXPECT_NEAR(rested.exchange.channel().motor_heat.load(), cooled, 0.01 * cooled);
}

TEST(HandleRest, RecordedRestRunsAgainBitForBit) {
    RestingRun run;
    run.go(rested_s + 2.0, [&](double now_s) {
        const double moved_m = now_s > rested_s + 1.0 ? 0.01 * (now_s - rested_s - 1.0) : 0.0;
        run.device.angles = angles_at(default_profile(), standing_place + Position{moved_m, 0.0});
    });
    const auto scene = line_scene(0.0);
    RecordedMap map;
    map.version = 1;
    map.gallery_file = "line.svg";
    const Recording recording = make_recording(run.recorder, "2diy-gen3.1", {map});
    const auto again = run_again(recording, [&](std::uint64_t /*version*/) {
        return Result<std::shared_ptr<const Scene>>(scene);
    });
    ASSERT_TRUE(again) << again.error().line;
    EXPECT_GT(again->ticks.size(), 1000U);
    EXPECT_FALSE(again->differs_at);
}

}  // namespace
}  // namespace touchline
