// A handle cannot jump, so a position too far from the last one is the encoder's error, not the
// hand's motion.
// Threads: a plain value.
#pragma once

#include "config/types/vec2.h"

#include <cstdint>

namespace touchline {

/// good: use it. held: use the last good one. jumped: the position stays where it jumped to; use
/// it, but without force.
enum class Sample : std::uint8_t { good, held, jumped };

class PositionGuard {
  public:
    /// `count_m` > 0: the tip's motion for one encoder count.
    explicit PositionGuard(double count_m) : count_m_(count_m) {}

    /// Judges a position measured dt_s > 0 after the tick before. The first one is good.
    Sample step(Position measured, double dt_s) {
        since_good_s_ += dt_s;
        const double possible_m = fastest_m_per_s * since_good_s_ + 2.0 * count_m_;
        if (!has_good_ || norm(measured - good_) <= possible_m) return take(measured, Sample::good);
        if (++held_ <= most_held) return Sample::held;
        return take(measured, Sample::jumped);
    }

    /// Advances a tick without a position.
    void miss(double dt_s) { since_good_s_ += dt_s; }

  private:
    static constexpr double fastest_m_per_s = 1.5;
    static constexpr int most_held = 3;  // ticks

    Sample take(Position measured, Sample sample) {
        good_ = measured;
        has_good_ = true;
        since_good_s_ = 0.0;
        held_ = 0;
        return sample;
    }

    double count_m_;
    Position good_;
    bool has_good_ = false;
    double since_good_s_ = 0.0;
    int held_ = 0;  // ticks in a row
};

}  // namespace touchline
