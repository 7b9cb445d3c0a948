// Private to app/decode: which of the words that tesseract sees are there. In photos and line
// drawings it sees letters everywhere; a label that nobody wrote misleads more than one that is
// missing.
// Threads: pure functions.
#pragma once

#include "app/decode/found_words.h"

#include <span>
#include <string>

namespace touchline::decode {

struct SeenWord {
    std::string text;         // UTF-8
    double confidence = 0.0;  // 0 ... 100, tesseract's own
    WordBox box;              // within the picture
    bool begins_line = false;
};

/// The words that can be believed, in a picture of this size; those that stand close in one line
/// become one label in their middle. O(words).
[[nodiscard]] FoundWords believed(std::span<const SeenWord> seen, int width, int height);

}  // namespace touchline::decode
