// Plays what the hand meets as sounds at the right time.
// Threads: one.
#pragma once

#include "audio-cues/cues/cue_step.h"
#include "audio-cues/output/frame_clock.h"
#include "audio-cues/synth/mixer.h"
#include "config/types/contact_event.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace touchline {

/// Maps the servo's time to this clock. A report is never early, and now and then it comes at once,
/// so the smallest delay so far is the offset between the clocks. The offset may grow a little,
/// because the clocks may run at different speeds.
class ServoClock {
  public:
    /// A report of the servo's time `servo_s` arrived at `now_ns`.
    void told(double servo_s, std::int64_t now_ns) {
        if (!std::isfinite(servo_s) || (last_s_ && servo_s == *last_s_)) return;
        const double offset_s = 1e-9 * static_cast<double>(now_ns) - servo_s;
        const bool is_new = !last_s_ || servo_s < *last_s_;  // another servo
        const double grown_s = is_new ? offset_s : offset_s_ + drift * (servo_s - *last_s_);
        offset_s_ = std::min(offset_s, grown_s);
        last_s_ = servo_s;
    }

    /// Nothing before the first report.
    [[nodiscard]] std::optional<std::int64_t> ns_of(double servo_s) const {
        if (!last_s_ || !std::isfinite(servo_s)) return std::nullopt;
        return std::llround(1e9 * (servo_s + offset_s_));
    }

    static constexpr double drift = 1e-4;  // seconds per second

  private:
    std::optional<double> last_s_;
    double offset_s_ = 0.0;
};

/// How much is heard, and where.
struct CueSetting {
    CueAmount amount = CueAmount::cues;
    CueArea area;
    ServoClock clock;
};

class HandCues {
  public:
    /// Both arguments must outlive it.
    HandCues(Mixer& mixer, const FrameClock& clock) : mixer_(mixer), clock_(clock) {}

    /// Sends the sound of this event for the frame of its time: less than 4 ms after the event if
    /// it is reported within a millisecond, else at once.
    void play(const ContactEvent& event, const CueSetting& setting);

  private:
    Mixer& mixer_;
    const FrameClock& clock_;
    CueState state_;
};

}  // namespace touchline
