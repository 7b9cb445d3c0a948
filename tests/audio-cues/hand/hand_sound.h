// What a simulated hand hears that follows a picture: the production servo step, cues and mixer, on
// a virtual clock. Threads: pure functions.
#pragma once

#include "audio-cues/cues/cue.h"
#include "audio-cues/synth/frames.h"
#include "config/types/contact_event.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"
#include "haptics/device/hand.h"

#include <vector>

namespace touchline {

/// One way of a hand over a map.
struct HandRun {
    std::vector<ContactEvent> events;
    std::vector<Position> handle;    // a tick of 1 ms each
    std::vector<double> distance_m;  // to the nearest outline
};

/// The hand means to go from point to point at `speed_m_per_s`, in a ridge, which lets it across.
/// The first half second is for the force to come. Fails where the map cannot be felt.
[[nodiscard]] Result<HandRun> follow(const TactileMap& map, const std::vector<Position>& way,
                                     double speed_m_per_s);

/// What is heard of it, from its first tick to half a second after its last.
[[nodiscard]] std::vector<StereoFrame> sound_of(const HandRun& run, CueAmount amount);

}  // namespace touchline
