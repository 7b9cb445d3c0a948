// Checkers of what force is allowed to be: the states of safety, the time to no torque, and what
// the board makes of what it was told.
#pragma once

#include "tests/machines/sim/kiosk/checkers/sight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace touchline {

/// Checks that the states of the force follow each other as they may, no faster than they may, and
/// that no force acts in a state that allows none.
class SafetyTransitionsChecker {
  public:
    void look(const TickSight& sight, Findings& findings) {
        if (sight.tick == nullptr) return;
        const TickRecord& tick = *sight.tick;
        if (sight.is_first_tick) {
            before_ = ForceState::off;
            since_s_ = sight.now_s;
            fault_ = Fault::none;
            force_ = {};
        }
        const ForceState now = tick.force_state;
        const auto demand = [&](bool holds, const char* words) {
            findings.demand(holds, "safety transitions", sight.now_s, [&] {
                return fmt::format("{}: state {} after {}, {:.3f} N", words, static_cast<int>(now),
                                   static_cast<int>(before_), norm(tick.force));
            });
        };
        demand(is_legal(before_, now), "this state cannot come now");
        demand((now == ForceState::fault) == (tick.fault != Fault::none),
               "a fault without its state, or without a name");
        demand(now != ForceState::fault || before_ != now || tick.fault >= fault_,
               "a fault became easier to clear by itself");
        const bool may_push = now == ForceState::ramp || now == ForceState::live;
        // Force of more than 1.5 N that is switched off is gone one tick later: no change is
        // faster.
        const bool is_falling =
            now == ForceState::off && norm(tick.force) <= norm(force_) - most_fall_N;
        demand(may_push || is_falling || tick.force == Force{}, "force where there is none");
        if (now != before_) {
            const double lasted_s = sight.now_s - since_s_;
            const bool was_armed = before_ == ForceState::armed && now == ForceState::ramp;
            const bool is_full = before_ == ForceState::ramp && now == ForceState::live;
            demand(!was_armed || lasted_s >= arm_s, "force came before its time");
            demand(!is_full || !is_starting_ || lasted_s >= resume_s, "full force too soon");
            is_starting_ = was_armed;
            since_s_ = sight.now_s;
        }
        before_ = now;
        fault_ = tick.fault;
        force_ = tick.force;
    }

  private:
    static constexpr double arm_s = 0.198;        // 0.2 s, less a tick at each end
    static constexpr double most_fall_N = 1.499;  // 1500 N/s for one tick
    // 0.5 s from armed to live; 0.3 s if the force was faded out and back on the way.
    static constexpr double resume_s = 0.298;

    static bool is_legal(ForceState before, ForceState now) {
        switch (now) {
            case ForceState::off:
            case ForceState::fault:
                return true;
            case ForceState::armed:
                return before != ForceState::live;
            case ForceState::ramp:
                return before != ForceState::off && before != ForceState::fault;
            case ForceState::live:
                return before == now || before == ForceState::ramp;
        }
        return false;
    }

    ForceState before_ = ForceState::off;
    Fault fault_ = Fault::none;
    Force force_;  // told in the tick before
    double since_s_ = 0.0;
    bool is_starting_ = false;
};

/// Checks that the motors are without torque in time after each cause.
class ZeroDeadlineChecker {
  public:
    /// Call this if a fault can be seen from `seen_s` of the board's time on while torque is on.
    void expect(SimFault fault, double seen_s) { open_.push_back({fault, seen_s}); }

    void look(const TickSight& sight, SimFigures& figures, Findings& findings) {
        std::erase_if(open_,
                      [&](const Open& open) { return is_over(open, sight, figures, findings); });
    }

  private:
    struct Open {
        SimFault fault;
        double seen_s;
    };

    static constexpr double looked_at_s = 0.2;     // later zeros come from the hand
    static constexpr double other_wire_s = 0.004;  // for another link fault at the same time

    static bool is_over(const Open& open, const TickSight& sight, SimFigures& figures,
                        Findings& findings) {
        const SimFaultKind& kind = kind_of(open.fault);
        const bool is_zero = sight.held == JointTorques{};
        const double until_s = is_zero ? sight.held_since_s : sight.now_s;
        const double after_s = std::max(0.0, until_s - open.seen_s);
        const bool may_block = sight.is_send_hanging && kind.link == LinkFault::none;
        const double bar_s = kind.zero_s.value_or(looked_at_s) + wire_s;
        if (is_zero && (after_s <= bar_s || !kind.zero_s)) {
            double& worst_s = figures.zero_s[static_cast<std::size_t>(open.fault)];
            if (after_s <= bar_s) worst_s = std::max(worst_s, after_s);
            return true;
        }
        if (!kind.zero_s) return after_s > looked_at_s;
        findings.demand(
            after_s <= bar_s + (may_block ? other_wire_s : 0.0), "zero deadline", sight.now_s, [&] {
                return fmt::format("{}: torque for {:.2f} ms after it", kind.name, 1e3 * after_s);
            });
        return is_zero || after_s > looked_at_s;
    }

    std::vector<Open> open_;
};

/// Checks that each motor makes what the servo told in one of its last ticks, or nothing. One motor
/// alone may make nothing: the driver completes a cut send with zeros, before the zero of its
/// resync.
class BoardTruthChecker {
  public:
    void look(const TickSight& sight, Findings& findings) {
        if (sight.is_first_tick) told_ = {};
        if (sight.tick != nullptr) told_[next_++ % told_.size()] = sight.tick->torques;
        if (sight.tick == nullptr || sight.held == JointTorques{}) return;
        for (const JointTorques& told : told_)
            if (is_same(told, sight.held)) return;
        findings.demand(false, "board truth", sight.now_s, [&] {
            return fmt::format("motors make {:.5f} and {:.5f} N m, which no tick told",
                               sight.held.x, sight.held.y);
        });
    }

  private:
    static constexpr double duty_step_Nm = 0.123 / 1023.0;

    static bool is_same(double told_Nm, double held_Nm) {
        return held_Nm == 0.0 || std::abs(told_Nm - held_Nm) <= 1.5 * duty_step_Nm;
    }

    static bool is_same(JointTorques told, JointTorques held) {
        return is_same(told.x, held.x) && is_same(told.y, held.y);
    }

    // One command is on its way; a late reply holds the next one back for up to 5 ms.
    std::array<JointTorques, 8> told_{};
    std::size_t next_ = 0;
};

}  // namespace touchline
