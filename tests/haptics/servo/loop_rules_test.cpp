// What the loop does when the kiosk falls silent, when ticks come late, and when it is cut, all on
// a virtual clock.
#include "haptics/servo/servo_loop.h"
#include "tests/haptics/servo/rigs.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr std::int64_t ms = 1'000'000;
constexpr Position above{0.0, 0.01};
constexpr Position pressed{0.0, -0.002};  // 2 mm below the line: 1 N at 500 N/m

/// Calls back before each tick, which then begins `late_ns` late.
class ScriptedClock final : public Clock {
  public:
    explicit ScriptedClock(std::function<void(std::int64_t)> before_tick)
        : before_tick_(std::move(before_tick)) {}

    [[nodiscard]] std::int64_t now_ns() override { return time_ns_; }

    void sleep_until(std::int64_t t_ns) override {
        time_ns_ = std::max(time_ns_, t_ns) + std::exchange(late_ns, 0);
        before_tick_(time_ns_);
    }

    std::int64_t late_ns = 0;

  private:
    std::function<void(std::int64_t)> before_tick_;
    std::int64_t time_ns_ = 0;
};

/// Runs the loop with a pressed handle and tells it what happens tick by tick.
class PressedRun {
  public:
    explicit PressedRun(const LoopRules& rules, std::int64_t period_ns = ms)
        : rules_(rules), period_ns_(period_ns) {
        exchange_.feel(line_scene(0.0));
    }

    /// Calls `script` before each tick with the time; the handle presses from 0.8 s on.
    void go(double until_s, const std::function<void(std::int64_t)>& script) {
        ServoLoop loop(device_, default_profile(), 1e-9 * static_cast<double>(period_ns_),
                       exchange_, recorder_, rules_);
        ScriptedClock clock([&](std::int64_t t_ns) {
            if (t_ns > 0) forces_.push_back({t_ns, norm(exchange_.report().hand.force)});
            wrote_torque_ = device_.written != JointTorques{};
            device_.angles = angles_at(default_profile(), move(t_ns));
            if (t_ns >= static_cast<std::int64_t>(until_s * 1e9)) end_.is_cut = true;
            script(t_ns);
            clock_ = &clock;
        });
        clock_ = &clock;
        loop.run(clock, period_ns_, end_);
    }

    /// Moves at 0.12 m/s, because a handle that leaps is a fault. Sways along the line, because one
    /// that rests counts as let go.
    Position move(std::int64_t t_ns) {
        const Position way = (t_ns < 700 * ms ? above : handle_later) - place_;
        const double longest_m = 0.12e-9 * static_cast<double>(period_ns_);
        const double share = norm(way) > longest_m ? longest_m / norm(way) : 1.0;
        place_ += share * way;
        return place_ + Position{5e-4 * std::sin(6e-9 * static_cast<double>(t_ns)), 0.0};
    }

    void beat() { ++channel().kiosk_beats; }

    ServoChannel& channel() { return exchange_.channel(); }

    /// Returns the force of the last tick that began by t_ns.
    [[nodiscard]] double force_N(std::int64_t t_ns) const {
        double force = 0.0;
        for (const auto& [at_ns, newest] : forces_)
            if (at_ns <= t_ns + period_ns_) force = newest;
        return force;
    }

    [[nodiscard]] std::int64_t last_force_ns() const {
        std::int64_t last = 0;
        for (const auto& [at_ns, force] : forces_)
            if (force > 0.0) last = at_ns;
        return last;
    }

    PlacedDevice device_{above};
    Position handle_later = pressed;
    ScriptedClock* clock_ = nullptr;
    LoopEnd end_;
    bool wrote_torque_ = false;

  private:
    Position place_ = above;
    LoopRules rules_;
    std::int64_t period_ns_;
    ServoExchange exchange_;
    Recorder recorder_;
    std::vector<std::pair<std::int64_t, double>> forces_;
};

LoopRules watching() {
    LoopRules rules;
    rules.granted = RealTimeTier::fifo;
    rules.watches_kiosk = true;
    return rules;
}

TEST(LoopRules, ForceIsZeroTwentyMillisecondsAfterTheKiosksLastBeat) {
    for (const std::int64_t period_ns : {ms / 4, ms / 2, ms, 2 * ms}) {
        PressedRun run(watching(), period_ns);
        std::int64_t last_beat_ns = 0;
        run.go(1.5, [&](std::int64_t t_ns) {
            if (t_ns > 1000 * ms) return;
            run.beat();
            last_beat_ns = t_ns;
        });
        EXPECT_GT(run.force_N(last_beat_ns), 0.5) << period_ns;
        EXPECT_GT(run.last_force_ns(), last_beat_ns);
        EXPECT_LE(run.last_force_ns(), last_beat_ns + 20 * ms) << period_ns;
        EXPECT_FALSE(run.wrote_torque_);
    }
}

TEST(LoopRules, ShortSilencesCostNothing) {
    PressedRun run(watching());
    run.go(1.5, [&](std::int64_t t_ns) {
        if (t_ns % (9 * ms) == 0) run.beat();
    });
    for (std::int64_t t_ns = 1000 * ms; t_ns < 1400 * ms; t_ns += ms) {
        ASSERT_GT(run.force_N(t_ns), 0.9);
    }
}

TEST(LoopRules, WithoutAnyBeatThereIsNoForce) {
    PressedRun run(watching());
    run.go(1.5, [](std::int64_t) {});
    EXPECT_EQ(run.last_force_ns(), 0);
}

TEST(LoopRules, AfterASilenceForceComesBackByTheArmRuleOnly) {
    PressedRun run(watching());
    run.go(3.5, [&](std::int64_t t_ns) {
        if (t_ns < 1000 * ms || t_ns > 1500 * ms) run.beat();
        if (t_ns >= 2000 * ms) run.handle_later = above;
        if (t_ns >= 2800 * ms) run.handle_later = pressed;
    });
    EXPECT_GT(run.force_N(999 * ms), 0.9);
    for (std::int64_t t_ns = 1020 * ms; t_ns < 2000 * ms; t_ns += ms) {
        ASSERT_EQ(run.force_N(t_ns), 0.0) << t_ns;  // pressed all the time, but pushes nobody
    }
    EXPECT_GT(run.force_N(3400 * ms), 0.9);
}

TEST(LoopRules, AThreadOfTheKioskNeedsNoBeat) {
    PressedRun run({});
    run.go(1.5, [](std::int64_t) {});
    EXPECT_GT(run.force_N(1400 * ms), 0.9);
}

TEST(LoopRules, AStandstillOfTheWholeMachineIsNotTheKiosksSilence) {
    PressedRun run(watching());
    run.go(1.5, [&](std::int64_t t_ns) {
        run.beat();
        if (t_ns == 1000 * ms) run.clock_->late_ns = 300 * ms;
    });
    EXPECT_GT(run.force_N(1350 * ms), 0.9);
}

TEST(LoopRules, AGapOfTenMillisecondsStopsAMotorForAMinute) {
    for (const bool has_motors : {true, false}) {
        LoopRules rules;
        rules.granted = RealTimeTier::fifo;
        rules.has_motors = has_motors;
        PressedRun run(rules);
        run.go(64.0, [&](std::int64_t t_ns) {
            if (t_ns == 1000 * ms) run.clock_->late_ns = 11 * ms;
            if (t_ns >= 62'000 * ms) run.handle_later = above;
            if (t_ns >= 63'000 * ms) run.handle_later = pressed;
            if (t_ns == 1100 * ms) {
                EXPECT_EQ(tier_of(run.channel()), RealTimeTier::too_late);
            }
        });
        EXPECT_GT(run.force_N(1000 * ms), 0.9);
        EXPECT_EQ(run.force_N(1030 * ms) == 0.0, has_motors);
        EXPECT_EQ(run.force_N(60'000 * ms) == 0.0, has_motors);
        EXPECT_GT(run.force_N(63'900 * ms), 0.9);
        EXPECT_EQ(tier_of(run.channel()), RealTimeTier::fifo);
    }
}

TEST(LoopRules, ManyLateTicksStopAMotor) {
    LoopRules rules;
    rules.granted = RealTimeTier::real_time;
    rules.has_motors = true;
    PressedRun run(rules);
    run.go(3.0, [&](std::int64_t t_ns) {
        if (t_ns >= 1000 * ms && t_ns % (10 * ms) == 0) run.clock_->late_ns = 3 * ms / 2;
    });
    EXPECT_GT(run.force_N(1200 * ms), 0.9);
    EXPECT_EQ(run.force_N(2900 * ms), 0.0);
    EXPECT_GT(run.channel().lateness.quantile_us(1.0), 1000);
}

TEST(LoopRules, WithoutRealTimePriorityAMotorMakesHalfTheForce) {
    for (const bool has_motors : {true, false}) {
        LoopRules rules;
        rules.granted = RealTimeTier::best_effort;
        rules.has_motors = has_motors;
        PressedRun run(rules);
        run.go(1.5, [](std::int64_t) {});
        EXPECT_NEAR(run.force_N(1400 * ms), has_motors ? 0.5 : 1.0, 0.02);
    }
}

TEST(LoopRules, CutIsZeroTorqueWithTheSameTick) {
    PressedRun run({});
    run.go(1.0, [](std::int64_t) {});
    EXPECT_TRUE(run.wrote_torque_);  // until then
    EXPECT_EQ(run.device_.written, JointTorques{});
}

TEST(LoopRules, AnEndWantedInTheChannelFadesOut) {
    PressedRun run({});
    run.go(5.0, [&](std::int64_t t_ns) {
        if (t_ns == 1000 * ms) run.channel().is_stop_wanted = 1;
    });
    EXPECT_LE(run.last_force_ns(), 1060 * ms);
    EXPECT_EQ(run.device_.written, JointTorques{});
}

}  // namespace
}  // namespace touchline
