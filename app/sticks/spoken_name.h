// Names of files as a person would read them aloud.
// Threads: pure functions.
#pragma once

#include "audio-cues/words/language.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace touchline {

inline constexpr std::size_t spoken_characters = 80;

/// The name of a file, any bytes, without its ending: words with the apostrophes between their
/// letters; what has no vowel, or is short and in capitals, letter by letter; a date with its time
/// in the language's own way, and every other number of more than three digits in pairs ("101085":
/// "10 10 85"), but for a year after a word. No markup is left for a voice to obey. At most
/// spoken_characters, cut between words where that is possible; "a file without a name" where
/// nothing is left. O(n).
[[nodiscard]] std::string spoken_name(std::string_view name, const Language& language);

}  // namespace touchline
