#include "app/sound/hand_cues.h"

#include "audio-cues/cues/cue_sounds.h"

namespace touchline {

void HandCues::play(const ContactEvent& event, const CueSetting& setting) {
    state_.amount = setting.amount;
    state_.area = setting.area;
    const CueStep step = cue_step(state_, event);
    state_ = step.state;
    if (!step.cue) return;
    const auto happened_ns = setting.clock.ns_of(step.cue->time_s);
    mixer_.send(sound_of(*step.cue, happened_ns ? clock_.frame_at(*happened_ns) : 0));
}

}  // namespace touchline
