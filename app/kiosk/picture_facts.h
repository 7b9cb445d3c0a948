// What a visitor can be told of the picture that is felt. Threads: pure functions.
#pragma once

#include "app/documents/sticks/spoken_name.h"
#include "app/kiosk/loading/stages.h"
#include "app/visit/visit_events.h"
#include "audio-cues/words/language.h"
#include "config/types/hand_state.h"
#include "config/types/tactile_map.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace touchline {

/// A hand this near a spot counts as on it: half of what a fingertip covers.
inline constexpr double spot_m = 0.004;

/// The title of a visitor's file is its name as its list says it, in `form`: what was chosen is
/// what is heard. A title of the document's own begins the description. Parts are the named
/// outlines, each name once, then the spots. O(outlines + labels).
[[nodiscard]] PictureFacts facts_of(const LoadedScene& scene, const PictureFile& file,
                                    const NameForm& form, const Language& language);

/// The part under the hand: the outline that it touches, else the nearest spot within spot_m.
/// O(parts + log outlines).
[[nodiscard]] std::optional<std::size_t> part_at(const TactileMap& map,
                                                 const std::vector<PartFacts>& parts,
                                                 const HandState& hand);

}  // namespace touchline
