// Decides when a servo that died is started again.
// Threads: a plain value; no clock.
#pragma once

#include <algorithm>

namespace touchline {

/// Waits half a second at first, doubled with each death, 8 s at most. A servo that ran for a
/// minute resets the wait.
class Restart {
  public:
    static constexpr double first_s = 0.5;
    static constexpr double longest_s = 8.0;
    static constexpr double healthy_s = 60.0;

    /// The wait after a servo that ran for `ran_s`.
    [[nodiscard]] double wait_s(double ran_s) {
        const double wait_s = ran_s >= healthy_s ? first_s : next_s_;
        next_s_ = std::min(2.0 * wait_s, longest_s);
        return wait_s;
    }

  private:
    double next_s_ = first_s;
};

}  // namespace touchline
