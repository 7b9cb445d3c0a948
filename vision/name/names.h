// Chooses what to say of the things that a network found in a picture: a word only if it is sure.
// Threads: pure functions.
#pragma once

#include "config/types/thing_name.h"
#include "vision/name/name_network.h"

#include <span>
#include <vector>

namespace touchline {

/// The most different names, and the most things.
inline constexpr std::size_t most_names = 3;
inline constexpr std::size_t most_named_things = 12;

/// Returns the names of the things found, the largest thing first. A thing gets its own word from a
/// likelihood on that depends on its kind (names.cpp). Below that it gets "an animal" or "a
/// vehicle", if no other animal or vehicle has a word of its own, or no word. Once a word is said,
/// more things of that kind count from a lower likelihood on. Nothing is said of what is not in
/// ThingName. `found` comes from detections_of. O(n log n).
[[nodiscard]] std::vector<NamedThing> names_of(std::span<const Detection> found);

/// Returns the places where a person may be, the likeliest first. These are more than are said: a
/// search for faces may look at all of them.
[[nodiscard]] std::vector<ThingBox> people_in(std::span<const Detection> found);

}  // namespace touchline
