// The level of resolution follows the hand's speed (facts: resolution by hand speed): coarse while the
// hand is fast, fine while it is slow.
// Threads: one, the servo's. No allocation.
#pragma once

#include "config/types/vec2.h"

namespace touchline {

struct LevelLimits {
    double spacing_m = 1e-4;       // h0: point spacing of level 0
    double encoder_step_m = 1e-4;  // smallest motion of the tip that the device can tell
    double f_device_Hz = 100.0;    // bandwidth of the device
    double finest = 0.0;           // the operator's bounds
    double coarsest = 16.0;
};

/// Level = min(coarsest, max(l_speed, l_encoder, finest)), with the peak-hold speed measure, hysteresis
/// and dwell of the speed rule.
class LevelRule {
  public:
    explicit LevelRule(const LevelLimits& limits) : limits_(limits) {}

    /// One servo tick. `dt_s` > 0. Returns the wanted whole level.
    double step(Position handle, double dt_s);

    [[nodiscard]] double speed_m_per_s() const { return held_speed_m_per_s_; }

  private:
    LevelLimits limits_;
    double held_speed_m_per_s_ = 0.0;
};

}  // namespace touchline
