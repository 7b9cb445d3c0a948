// Whether the loop may tick more slowly: nobody is here, no force acts and the handle stands still.
// Threads: one, the servo's. A plain value.
#pragma once

#include "config/types/vec2.h"

#include <cstdint>

namespace touchline {

/// The time between ticks of a loop that rests. Every silence that somebody answers is longer: 10
/// ms are a gap of the loop, 12 ms too many for the guard, 20 ms for motors with a watchdog.
inline constexpr double resting_period_s = 0.008;

/// Returns how many periods a loop that rests lets pass from tick to tick; one where its period is
/// as long as that. period_s > 0.
[[nodiscard]] constexpr std::int64_t resting_periods(double period_s) {
    const double periods = resting_period_s / period_s;
    return periods > 1.0 ? static_cast<std::int64_t>(periods) : 1;
}

class HandleRest {
  public:
    /// How long a handle must have stood still.
    static constexpr double least_s = 30.0;
    /// So far may the counts of an encoder make a handle seem to move that stands still.
    static constexpr double most_m = 2e-4;

    /// Advances one tick, `dt_s` >= 0 after the one before. `may_rest`: nobody is here, no force
    /// acts, and `p_WH` is where the handle is now. O(1).
    void step(bool may_rest, Position p_WH, double dt_s) {
        if (may_rest && norm(p_WH - place_) <= most_m) {
            still_s_ += dt_s;
        } else {
            place_ = p_WH;
            still_s_ = 0.0;
        }
    }

    [[nodiscard]] bool is_resting() const { return still_s_ >= least_s; }

  private:
    Position place_;  // where it began to stand still
    double still_s_ = 0.0;
};

}  // namespace touchline
