// Decides when a guard kills its servo, by the servo's channel, beat by beat.
// Threads: a plain value, the guard's; no clock.
#pragma once

#include "haptics/servo/exchange.h"
#include "haptics/servo/peer_watch.h"

namespace touchline {

/// The time between two looks of the guard.
inline constexpr int guard_beat_ms = 2;

class ServoWatch {
  public:
    /// One look, `dt_s` after the one before. `is_end_wanted`: the servo was asked to end. True if
    /// it has to be killed, because it
    ///   - is silent for 12 ms with torque on, so that the device can be opened and zeroed,
    ///   - is silent for 0.5 s without torque, when it may only have been slow,
    ///   - has not begun to tick 10 s after its start, or not ended 2 s after it was asked to.
    [[nodiscard]] bool step(const ServoChannel& channel, bool is_end_wanted, double dt_s) {
        const std::uint64_t beats = channel.servo_beats.load();
        since_start_s_ += dt_s;
        if (is_end_wanted) since_end_wanted_s_ += dt_s;
        const bool is_silent_under_force =
            under_force_.step(beats, dt_s) && channel.is_force_on.load() != 0;
        const bool is_silent = at_rest_.step(beats, dt_s);
        const bool is_overdue = since_end_wanted_s_ > longest_end_s;
        const bool is_stuck = beats != 0 ? is_silent : since_start_s_ > longest_start_s;
        return is_silent_under_force || (is_stuck && !is_end_wanted) || is_overdue;
    }

  private:
    static constexpr double longest_look_s = 2.0 * guard_beat_ms * 1e-3;
    static constexpr double longest_silence_under_force_s = 0.012;
    static constexpr double longest_silence_s = 0.5;
    static constexpr double longest_start_s = 10.0;
    static constexpr double longest_end_s = 2.0;

    PeerWatch under_force_{longest_silence_under_force_s, longest_look_s};
    PeerWatch at_rest_{longest_silence_s, longest_look_s};
    double since_start_s_ = 0.0;
    double since_end_wanted_s_ = 0.0;
};

}  // namespace touchline
