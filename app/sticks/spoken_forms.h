// Decides how much of each name of a list is said, so that no two sound alike.
// Threads: pure functions.
#pragma once

#include "app/sticks/spoken_name.h"
#include "audio-cues/words/language.h"

#include <span>
#include <string>
#include <vector>

namespace touchline {

/// The form of each name of a list, as plain as possible while no two sound alike in any of these
/// languages. Numbers names that have the same words in every form. Capitals, and how an accent is
/// written, are not heard. O(n log n) of all names, for each language.
[[nodiscard]] std::vector<NameForm> spoken_forms(std::span<const std::string> names,
                                                 std::span<const Language> languages);

}  // namespace touchline
