// Puts cues into words. Threads: pure functions.
#pragma once

#include "audio-cues/cues/guidance.h"
#include "audio-cues/words/language.h"

#include <string>

namespace touchline {

/// Returns words such as "upper left".
[[nodiscard]] std::string words_of(Place place, const Language& language);

/// Returns the name of a sound, as in the list of sounds.
[[nodiscard]] std::string words_of(Cue cue, const Language& language);

}  // namespace touchline
