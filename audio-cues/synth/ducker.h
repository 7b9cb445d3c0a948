// Lowers one bus while another sounds. Threads: the rendering thread's.
#pragma once

namespace touchline {

inline constexpr double duck_dB = -12.0;
inline constexpr double duck_down_s = 0.03;  // all the way
inline constexpr double duck_hold_s = 0.30;  // the pause between two sentences
inline constexpr double duck_up_s = 0.25;    // all the way

class Ducker {
  public:
    /// Advances by `seconds`, during which `is_other_sounding` holds. Returns the gain to arrive
    /// at, 1 if nothing has sounded for duck_hold_s and duck_up_s.
    double step(bool is_other_sounding, double seconds);

    [[nodiscard]] double gain() const { return gain_; }

  private:
    double level_dB_ = 0.0;
    double hold_s_ = 0.0;
    double gain_ = 1.0;
};

}  // namespace touchline
