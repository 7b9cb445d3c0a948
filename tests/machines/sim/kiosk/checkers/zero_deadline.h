// Checks that the motors are without torque in time after each cause.
#pragma once

#include "tests/machines/sim/kiosk/checkers/sight.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

namespace touchline {

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

}  // namespace touchline
