// Checks that a handle that nobody holds is not driven about, and not pushed for long.
#pragma once

#include "tests/machines/sim/kiosk/checkers/sight.h"

#include <fmt/format.h>

namespace touchline {

class NoHandChecker {
  public:
    void look(const TickSight& sight, Findings& findings) {
        const double force_N = norm(sight.force_W);
        const bool is_driven =
            !sight.is_hand_on && force_N > driving_N && norm(sight.tip.velocity) > moving_m_per_s;
        driven_s_ = is_driven ? driven_s_ + tick_s : 0.0;
        pushed_s_ = !sight.is_hand_on && force_N > pushing_N ? pushed_s_ + tick_s : 0.0;
        findings.demand(driven_s_ <= longest_drive_s, "no hand", sight.now_s, [&] {
            return fmt::format("{:.2f} N drove a handle that nobody holds for {:.3f} s", force_N,
                               driven_s_);
        });
        findings.demand(pushed_s_ <= longest_push_s, "no hand", sight.now_s, [&] {
            return fmt::format("{:.2f} N pushed a handle that nobody holds for {:.1f} s", force_N,
                               pushed_s_);
        });
    }

  private:
    static constexpr double tick_s = 1e-3;
    static constexpr double driving_N = 0.7;  // less is within the noise of the encoders
    static constexpr double moving_m_per_s = 0.02;
    static constexpr double longest_drive_s = 0.15;  // 30 ms to tell, in windows of 10 ms, 50 ms to
                                                     // fade
    static constexpr double pushing_N = 0.55;
    static constexpr double longest_push_s = 20.2;

    double driven_s_ = 0.0;
    double pushed_s_ = 0.0;
};

}  // namespace touchline
