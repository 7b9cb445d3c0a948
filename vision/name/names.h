// What is said of the things that a network found in a picture: a word only where it is sure.
// Threads: pure functions.
#pragma once

#include "config/types/thing_name.h"
#include "vision/name/detections.h"

#include <span>
#include <vector>

namespace touchline {

/// So many different names at most, and so many things.
inline constexpr std::size_t most_names = 3;
inline constexpr std::size_t most_named_things = 12;

/// The names of what was found, the largest thing first. A thing gets its own word from a
/// likelihood on that depends on its kind (names.cpp); below that "an animal" or "a vehicle", where
/// no other animal or vehicle has a word of its own; or none. Where a word is said, more things of
/// it count from a lower likelihood on. Of what is not in ThingName nothing is said. `found`: by
/// detections_of. O(n log n).
[[nodiscard]] std::vector<NamedThing> names_of(std::span<const Detection> found);

/// Where there may be a person, the likeliest first. These are more than are said: a search for
/// faces may look at all of them.
[[nodiscard]] std::vector<ThingBox> people_in(std::span<const Detection> found);

}  // namespace touchline
