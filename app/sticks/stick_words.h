// What a list of a stick's files leaves out, in the visitor's language.
// Threads: pure functions.
#pragma once

#include "app/sticks/listing.h"
#include "audio-cues/words/language.h"

#include <cstddef>
#include <string>

namespace touchline {

/// Whole sentences: what is not in the list of `listed` files, why, and what to do about it. Empty
/// where all is.
[[nodiscard]] std::string words_of(const StickRest& rest, std::size_t listed,
                                   const Language& language);

/// The same where there is nothing at all that could be chosen.
[[nodiscard]] std::string nothing_words(const StickRest& rest, const Language& language);

}  // namespace touchline
