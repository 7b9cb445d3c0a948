// Force never drives on a hand that is already fast, and a hand faster than hands can be is a
// fault.
// Threads: a pure function and a plain value.
#pragma once

#include "config/types/vec2.h"

namespace touchline {

inline constexpr double braked_m_per_s = 1.0;      // from here on force only brakes
inline constexpr double too_fast_m_per_s = 1.5;    // a fault ...
inline constexpr double slow_again_m_per_s = 0.2;  // ... until it was slower than this ...
inline constexpr double slow_again_s = 1.0;        // ... for so long

/// True if force must not drive the hand on. A NaN velocity counts as fast.
[[nodiscard]] inline bool is_braked(Velocity velocity) {
    return !(norm(velocity) <= braked_m_per_s);
}

/// Takes away the part of the force that drives the motion on; parts across the motion and against
/// it stay.
[[nodiscard]] inline Force without_drive(Force force, Velocity velocity) {
    constexpr double nothing_N = 1e-9;  // squares of much less are lost
    if (!(norm(force) > nothing_N)) return {};
    // Brakes by a trace more than nothing, so that no rounding or scaling makes it drive.
    const double trace = 1e-12 * norm(force) * norm(velocity);
    const double drive = dot(force, velocity) + trace;
    if (!(drive > 0.0)) return force;
    return force - along<Force>(velocity, drive / dot(velocity, velocity));
}

class SpeedWatch {
  public:
    /// Advances one tick of dt_s > 0. Returns true while the hand is, or lately was, too fast.
    bool step(double speed_m_per_s, double dt_s) {
        slow_s_ = speed_m_per_s < slow_again_m_per_s ? slow_s_ + dt_s : 0.0;
        if (!(speed_m_per_s <= too_fast_m_per_s)) is_too_fast_ = true;
        if (slow_s_ >= slow_again_s) is_too_fast_ = false;
        return is_too_fast_;
    }

  private:
    bool is_too_fast_ = false;
    double slow_s_ = 0.0;
};

}  // namespace touchline
