// Says names of files as a person would read them aloud: how much of each name of a list, and what
// the list leaves out.
// Threads: pure functions.
#pragma once

#include "app/documents/sticks/listing.h"
#include "audio-cues/words/language.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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

/// The form of each name of a list, as plain as possible while no two sound alike in any of these
/// languages. Numbers names that have the same words in every form. Capitals, and how an accent is
/// written, are not heard. O(n log n) of all names, for each language.
[[nodiscard]] std::vector<NameForm> spoken_forms(std::span<const std::string> names,
                                                 std::span<const Language> languages);

/// Whole sentences: what is missing from the list of `listed` files, why, and what to do about it.
/// Empty if nothing is.
[[nodiscard]] std::string words_of(const StickRest& rest, std::size_t listed,
                                   const Language& language);

/// The same if there is nothing to choose from.
[[nodiscard]] std::string nothing_words(const StickRest& rest, const Language& language);

}  // namespace touchline
