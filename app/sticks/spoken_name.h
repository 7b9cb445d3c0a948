// Names of files as a person would read them aloud.
// Threads: pure functions.
#pragma once

#include "audio-cues/words/language.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace touchline {

inline constexpr std::size_t spoken_characters = 80;

/// How much of a name is said. plain: as people name a file. precise: with the seconds of its time.
/// with_ending: plain, and how the file ends. whole: all of it.
enum class NameDetail : std::uint8_t { plain, precise, with_ending, whole };

struct NameForm {
    NameDetail detail = NameDetail::plain;
    int number = 0;  // among those that sound alike all the same; 0: none does

    friend bool operator==(const NameForm&, const NameForm&) = default;
};

/// The name of a file, any bytes: words with the apostrophes between their letters; what has no
/// vowel, or is short and in capitals beside small letters, letter by letter; a date with its time
/// in the language's own way, and every other number of more than three digits in pairs ("101085":
/// "10 10 85"), but for a year after a word. What a camera writes before its number or date is
/// "photo", its number has no zeros before it ("DSC04512.JPG": "photo 45 12"), and the ending is
/// not said: the whole form has all of that. No markup is left for a voice to obey. At most
/// spoken_characters besides its ending and number, cut between words where that is possible; "a
/// file without a name" where nothing is left. O(n).
[[nodiscard]] std::string spoken_name(std::string_view name, const Language& language,
                                      const NameForm& form = {});

}  // namespace touchline
