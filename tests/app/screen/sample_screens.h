// Screens of every kind, made from words of the catalogues, for measuring how they are drawn.
#pragma once

#include "app/visit/screen_model.h"
#include "audio-cues/words/language.h"

#include <string>
#include <vector>

namespace touchline {

struct NamedScreen {
    std::string name;
    SpokenScreen screen;
};

/// Returns English and every catalogue. Throws if one cannot be read.
[[nodiscard]] std::vector<Language> every_language();

/// Returns a list, settings beside a picture, a camera, a text of many pages, and a list of 500.
[[nodiscard]] std::vector<NamedScreen> sample_screens(const Language& language);

/// Makes every text two fifths longer, within its words, as a language might that has no
/// translation yet.
[[nodiscard]] SpokenScreen stretched(SpokenScreen screen);
[[nodiscard]] std::string stretched(const std::string& text);

}  // namespace touchline
