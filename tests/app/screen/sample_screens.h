// Screens of every kind, made from words that the catalogues have, for measuring how they are
// drawn.
#pragma once

#include "app/session/screen_model.h"
#include "audio-cues/words/language.h"

#include <string>
#include <vector>

namespace touchline {

struct NamedScreen {
    std::string name;
    SpokenScreen screen;
};

/// English and every catalogue. Throws where one cannot be read.
[[nodiscard]] std::vector<Language> every_language();

/// A list, settings beside a picture, a camera, a text of many pages, a list of 500.
[[nodiscard]] std::vector<NamedScreen> sample_screens(const Language& language);

/// With every text two fifths longer, inside its words: what a language does that nobody has
/// translated to yet.
[[nodiscard]] SpokenScreen stretched(SpokenScreen screen);
[[nodiscard]] std::string stretched(const std::string& text);

}  // namespace touchline
