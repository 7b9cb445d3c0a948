// What a simulated hand hears as it follows a picture: the production servo step, cues and mixer,
// on a virtual clock. Threads: pure functions.
#pragma once

#include "audio-cues/cues/cue_table.h"
#include "audio-cues/synth/frames.h"
#include "config/types/contact_event.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"
#include "haptics/device/simulated/simulated_pantograph.h"

#include <vector>

namespace touchline {

/// One run of a hand over a map.
struct HandRun {
    std::vector<ContactEvent> events;
    std::vector<Position> handle;    // one per tick of 1 ms
    std::vector<double> distance_m;  // to the nearest outline
};

/// The hand aims from point to point at `speed_m_per_s`, in ridge mode, which lets it across. In
/// the first half second the force comes on. Fails if the map cannot be felt.
[[nodiscard]] Result<HandRun> follow(const TactileMap& map, const std::vector<Position>& way,
                                     double speed_m_per_s);

/// Returns the sound of a run, from its first tick to half a second after its last.
[[nodiscard]] std::vector<StereoFrame> sound_of(const HandRun& run, CueAmount amount);

}  // namespace touchline
