// How long the handle has been held still.
// Threads: a plain value.
#pragma once

#include "config/types/vec2.h"

#include <cmath>

namespace touchline {

class Stillness {
  public:
    /// band > 0 (rad): a hand that rests moves each joint by less, its encoder's last count
    /// included.
    explicit Stillness(JointAngles band) : band_(band) {}

    /// One tick of dt_s later. Angles that are not finite are motion.
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
