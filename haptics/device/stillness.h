// Measures how long the handle has been held still.
// Threads: a plain value.
#pragma once

#include "config/types/vec2.h"

#include <cmath>

namespace touchline {

class Stillness {
  public:
    /// band > 0 (rad): a resting hand moves each joint by less, including its encoder's last count.
    explicit Stillness(JointAngles band) : band_(band) {}

    /// Advances one tick of dt_s. Angles that are not finite count as motion.
    void step(JointAngles angles, double dt_s) {
        const JointAngles moved = angles - middle_;
        const bool is_inside = std::abs(moved.x) <= band_.x && std::abs(moved.y) <= band_.y;
        if (!is_inside) middle_ = angles;
        still_s_ = is_inside ? still_s_ + dt_s : 0.0;
    }

    /// Counts anew from the next tick on.
    void start_again() { still_s_ = 0.0; }

    [[nodiscard]] double still_s() const { return still_s_; }

  private:
    JointAngles band_;
    JointAngles middle_;
    double still_s_ = 0.0;
};

}  // namespace touchline
