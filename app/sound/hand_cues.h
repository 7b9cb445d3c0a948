// What the hand meets, as sounds at their time.
// Threads: one.
#pragma once

#include "app/sound/servo_clock.h"
#include "audio-cues/cues/cue_step.h"
#include "audio-cues/output/frame_clock.h"
#include "audio-cues/synth/mixer.h"
#include "config/types/contact_event.h"

namespace touchline {

/// Of how much is heard, and where.
struct CueSetting {
    CueAmount amount = CueAmount::cues;
    CueArea area;
    ServoClock clock;
};

class HandCues {
  public:
    /// Both must outlive it.
    HandCues(Mixer& mixer, const FrameClock& clock) : mixer_(mixer), clock_(clock) {}

    /// Sends what this event sounds like, for the frame that belongs to its time: less than 4 ms
    /// after it if it is told within a millisecond, else at once.
    void play(const ContactEvent& event, const CueSetting& setting);

  private:
    Mixer& mixer_;
    const FrameClock& clock_;
    CueState state_;
};

}  // namespace touchline
