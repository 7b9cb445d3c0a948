// What a visitor hears of a list of files: how much of each name, and what the list leaves out.
// Threads: pure functions.
#pragma once

#include "app/documents/sticks/listing.h"
#include "app/documents/sticks/spoken_name.h"
#include "audio-cues/words/language.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace touchline {

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
