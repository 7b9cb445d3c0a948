// Checks that the states of the force follow each other as they may, no faster than they may, and
// that no force acts in a state that allows none.
#pragma once

#include "tests/machines/sim/kiosk/checkers/sight.h"

#include <fmt/format.h>

namespace touchline {

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

}  // namespace touchline
