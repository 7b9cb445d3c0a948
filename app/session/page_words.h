// Says which page of a document is felt, and which part of it.
// Threads: a pure function.
#pragma once

#include "app/session/page_place.h"
#include "audio-cues/words/language.h"

#include <string>

namespace touchline {

/// "Page 2 of 10. Picture 1 of 3 on this page"; empty for a document of one page and one picture.
[[nodiscard]] std::string words_of(const PagePlace& place, const Language& language);

}  // namespace touchline
