// What cues say in words. Threads: pure functions.
#pragma once

#include "audio-cues/cues/guidance.h"
#include "audio-cues/words/language.h"

#include <string>

namespace touchline {

/// "upper left".
[[nodiscard]] std::string words_of(Place place, const Language& language);

/// The name of a sound, as the list of sounds says it.
[[nodiscard]] std::string words_of(Cue cue, const Language& language);

}  // namespace touchline
