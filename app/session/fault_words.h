// The words for the force, on the panel and by voice, in one table.
// Threads: constant data and pure functions.
#pragma once

#include "audio-cues/words/language.h"
#include "config/types/force_status.h"

#include <string>
#include <string_view>

namespace touchline {

/// Whole sentences in English for a person who may not see the screen. A visitor has no key that
/// brings the force back; only the staff can end a fault.
struct FaultWords {
    std::string_view why;
    std::string_view visitor_does;
    std::string_view staff_does;
};

/// Returns the words of any fault but none.
[[nodiscard]] FaultWords words_of(Fault fault);

/// Says that the force is off, why, what the visitor can do, and that exploring goes on. Empty for
/// none.
[[nodiscard]] std::string spoken_fault(Fault fault, const Language& language);

/// The same for the staff: adds what they do, and the item of their menu that ends the fault if it
/// does not end by itself.
[[nodiscard]] std::string staffs_fault(Fault fault, const Language& language);

/// A few words, like "on" or "waiting until the hand is clear of lines".
[[nodiscard]] std::string_view words_of(ForceState state);

/// Why the force is reduced; empty if nothing worth a word reduces it.
[[nodiscard]] std::string_view words_of(Limit limit);

}  // namespace touchline
