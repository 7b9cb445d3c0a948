// Says names of files as a person would read them aloud.
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
/// with_ending: plain, with the ending. whole: all of it.
enum class NameDetail : std::uint8_t { plain, precise, with_ending, whole };

struct NameForm {
    NameDetail detail = NameDetail::plain;
    int number = 0;  // its number among names that still sound alike; 0: none does

    friend bool operator==(const NameForm&, const NameForm&) = default;
};

/// Says the name of a file, any bytes. Words keep the apostrophes between their letters. A word
/// without a vowel, or a short one in capitals beside small letters, is said letter by letter. A
/// date with its time is said in the language's own way, and every other number of more than three
/// digits in pairs ("101085": "10 10 85"), except a year after a word. What a camera writes before
/// its number or date becomes "photo", its number loses leading zeros ("DSC04512.JPG": "photo 45
/// 12"), and the ending is not said; the whole form keeps all of that. Leaves no markup for a voice
/// to obey. At most spoken_characters besides its ending and number, cut between words if possible;
/// "a file without a name" if nothing is left. O(n).
[[nodiscard]] std::string spoken_name(std::string_view name, const Language& language,
                                      const NameForm& form = {});

}  // namespace touchline
