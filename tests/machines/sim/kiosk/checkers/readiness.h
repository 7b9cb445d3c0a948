// Checks that force may come again within five seconds after a fault is over.
#pragma once

#include "tests/machines/sim/kiosk/checkers/sight.h"

#include <algorithm>

#include <fmt/format.h>

namespace touchline {

class ReadinessChecker {
  public:
    void look(const FrameSight& sight, SimFigures& figures, Findings& findings) {
        const double after_s = sight.now_s - free_since_s_;
        if (sight.is_blocked || sight.is_servo_ready) {
            if (was_waiting_ && !sight.is_blocked)
                figures.longest_ready_s = std::max(figures.longest_ready_s, after_s);
            was_waiting_ = !sight.is_servo_ready;
            free_since_s_ = sight.now_s;
            return;
        }
        was_waiting_ = true;
        findings.demand(after_s <= longest_s, "readiness", sight.now_s, [&] {
            return fmt::format("not ready {:.1f} s after what was wrong ended, fault {}", after_s,
                               static_cast<int>(sight.kiosk.force().fault));
        });
    }

  private:
    static constexpr double longest_s = 5.0;

    double free_since_s_ = 0.0;
    bool was_waiting_ = false;
};

}  // namespace touchline
