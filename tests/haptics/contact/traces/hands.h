// Hands that lead the reference traces over lines. The same seed gives the same hand.
#pragma once

#include "tests/haptics/contact/traces/trace.h"

#include <random>

namespace touchline::traces {

class Chance {
  public:
    explicit Chance(unsigned seed) : random_(seed) {}

    /// Returns 0 ... 1.
    double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }

    double about(double size) { return size * (2.0 * unit() - 1.0); }

    /// Returns 0 ... count - 1.
    int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }

    template <class T>
    const T& one_of(const std::vector<T>& all) {
        return all[static_cast<std::size_t>(below(static_cast<int>(all.size())))];
    }

  private:
    std::mt19937 random_;
};

struct Hand {
    double speed_m_per_s = 0.0;  // along a line; 0: leaps from place to place
    double aside_m = 2e-3;       // from the line, about
    double grid_m = 0.0;         // > 0: every position is on a grid
    int ticks_at_a_line = 48;    // then it starts anew at another
    double new_level = 0.08;     // chance per tick
    double kept = 0.9;           // of its offset aside, from tick to tick; 0: anywhere
};

/// Returns the given columns of a trace: along a line or from place to place, then anew at another
/// line, with a change of mode and level now and then.
[[nodiscard]] std::vector<Row> hand_over(const TactileMap& map, const Hand& hand,
                                         const std::vector<Mode>& modes,
                                         const std::vector<double>& levels, unsigned seed);

}  // namespace touchline::traces
