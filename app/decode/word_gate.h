// Private to app/decode: decides which of the words that tesseract sees exist. It sees letters
// everywhere in photos and line drawings, and a label that nobody wrote misleads more than a
// missing one.
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

/// The credible words in a picture of this size. Words that stand close in one line become one
/// label in their middle. O(words).
[[nodiscard]] FoundWords believed(std::span<const SeenWord> seen, int width, int height);

}  // namespace touchline::decode
