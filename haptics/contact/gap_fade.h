// Joins the forces before and after a change that the hand did not make: a switch of mode, or a
// wall that lets the hand through. Threads: a plain value.
#pragma once

#include "config/types/vec2.h"

namespace touchline {

/// What is missing from the force before the change. It shrinks by 20 N/s: 0.02 N a tick, 50 ms for
/// 1 N. Its work on a hand at speed v is at most gap^2 v / (40 N/s).
class GapFade {
  public:
    /// From here on the force continues from `before`, although the change made it `after`.
    void start(Force before, Force after) {
        gap_ = is_finite(before - after) ? before - after : Force{};
    }

    /// Returns the force to add in this tick.
    [[nodiscard]] Force step(double dt_s) {
        const Force now = gap_;
        const double size_N = norm(gap_);
        const double step_N = rate_N_per_s * dt_s;
        gap_ = size_N > step_N ? (1.0 - step_N / size_N) * gap_ : Force{};
        return now;
    }

    [[nodiscard]] bool is_open() const { return gap_ != Force{}; }

  private:
    static constexpr double rate_N_per_s = 20.0;

    Force gap_;
};

}  // namespace touchline
