// What is said of the force, on the panel and by voice: one table.
// Threads: constant data and pure functions.
#pragma once

#include "audio-cues/words/language.h"
#include "config/types/force_status.h"

#include <string>
#include <string_view>

namespace touchline {

/// Whole sentences for a person who may not see the screen.
struct FaultWords {
    std::string_view what;
    std::string_view why;
    std::string_view what_to_do;
};

/// Of every fault but none.
[[nodiscard]] FaultWords words_of(Fault fault);

/// The three, and that exploring goes on, in a language.
[[nodiscard]] std::string spoken_fault(Fault fault, const Language& language);

/// The three, and that sound goes on without force. Empty for none.
[[nodiscard]] std::string announcement_of(Fault fault);

/// A few words, like "on" or "waiting until the hand is clear of lines".
[[nodiscard]] std::string_view words_of(ForceState state);

/// Why the force is less than it would be; empty where nothing worth a word reduces it.
[[nodiscard]] std::string_view words_of(Limit limit);

}  // namespace touchline
