// What is said of the force, on the panel and by voice: one table.
// Threads: constant data and pure functions.
#pragma once

#include "audio-cues/words/language.h"
#include "config/types/force_status.h"

#include <string>
#include <string_view>

namespace touchline {

/// Whole sentences for a person who may not see the screen, in English. A visitor has no key that
/// brings the force back: what ends the fault is the staff's.
struct FaultWords {
    std::string_view why;
    std::string_view visitor_does;
    std::string_view staff_does;
};

/// Of every fault but none.
[[nodiscard]] FaultWords words_of(Fault fault);

/// That the force is off, why, what the visitor can do, and that exploring goes on. Empty for none.
[[nodiscard]] std::string spoken_fault(Fault fault, const Language& language);

/// The same for the staff: with what they do, and the item of their menu that ends the fault where
/// it does not end by itself.
[[nodiscard]] std::string staffs_fault(Fault fault, const Language& language);

/// A few words, like "on" or "waiting until the hand is clear of lines".
[[nodiscard]] std::string_view words_of(ForceState state);

/// Why the force is less than it would be; empty where nothing worth a word reduces it.
[[nodiscard]] std::string_view words_of(Limit limit);

}  // namespace touchline
