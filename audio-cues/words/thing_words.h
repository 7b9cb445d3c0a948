// What a network takes the things of a picture for, in words. Threads: pure functions.
#pragma once

#include "audio-cues/words/language.h"
#include "config/types/thing_name.h"

#include <span>
#include <string>

namespace touchline {

/// "a dog", "3 dogs"; from 4 on "4 dogs or more", as nobody counts on a network. `count` >= 1.
[[nodiscard]] std::string words_of(ThingName name, int count, const Language& language);

/// "on the left", "at the top, right of the middle", "in most of the picture".
[[nodiscard]] std::string words_of(const ThingBox& box, const Language& language);

/// "Probably a dog, left of the middle. And probably 2 people, on the right.": a sentence for each
/// name, in the order in which the names first come; a guess is told as one. "" for no things.
/// Boxes are sound.
[[nodiscard]] std::string words_of(std::span<const NamedThing> things, const Language& language);

}  // namespace touchline
