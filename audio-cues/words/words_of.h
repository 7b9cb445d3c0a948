// Places, sounds, and what a network sees in a picture, in words. Threads: pure functions.
#pragma once

#include "audio-cues/cues/guidance.h"
#include "audio-cues/words/language.h"
#include "config/types/thing_name.h"

#include <span>
#include <string>

namespace touchline {

/// Returns words such as "upper left".
[[nodiscard]] std::string words_of(Place place, const Language& language);

/// Returns the name of a sound, as in the list of sounds.
[[nodiscard]] std::string words_of(Cue cue, const Language& language);

/// Returns "a dog", "3 dogs"; from 4 on "4 dogs or more", because a network's count is unreliable.
/// `count` >= 1.
[[nodiscard]] std::string words_of(ThingName name, int count, const Language& language);

/// Returns "on the left", "at the top, right of the middle", "in most of the picture".
[[nodiscard]] std::string words_of(const ThingBox& box, const Language& language);

/// Returns "Probably a dog, left of the middle. And probably 2 people, on the right.": a sentence
/// for each name, in the order in which the names first appear; each guess is told as a guess.
/// Returns "" for no things. Boxes must be sound.
[[nodiscard]] std::string words_of(std::span<const NamedThing> things, const Language& language);

}  // namespace touchline
