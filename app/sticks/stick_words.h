// Says in the visitor's language what a list of a stick's files leaves out.
// Threads: pure functions.
#pragma once

#include "app/sticks/listing.h"
#include "audio-cues/words/language.h"

#include <cstddef>
#include <string>

namespace touchline {

/// Whole sentences: what is missing from the list of `listed` files, why, and what to do about it.
/// Empty if nothing is.
[[nodiscard]] std::string words_of(const StickRest& rest, std::size_t listed,
                                   const Language& language);

/// The same if there is nothing to choose from.
[[nodiscard]] std::string nothing_words(const StickRest& rest, const Language& language);

}  // namespace touchline
