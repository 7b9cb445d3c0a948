// Words that were read in the pixels of a page that has no text of its own: how they join it.
// Reading takes seconds, so a page is felt first and gets its labels when they are ready:
//
//   if (needs_reading(page)) ... words = read_words(page.picture) (words_in_picture.h) ...
//   page = with_words(std::move(page), *words);
//
// Threads: values and pure functions.
#pragma once

#include "app/decode/page.h"

#include <cstddef>
#include <span>
#include <vector>

namespace touchline {

struct FoundWords {
    int width = 0;  // of the picture that was read, in pixels
    int height = 0;
    std::vector<WordBox> boxes;  // of every word, within it
    Area area;                   // with the picture's proportions
    std::vector<Label> labels;   // one for words that stand close in one line; places within area
};

/// Is there something to read: pixels, no words known in them, and no lines that the file itself
/// says are to be felt?
[[nodiscard]] bool needs_reading(const Page& page);

/// The page with the words as labels, and their boxes as what is not to be felt. A page that needs
/// no reading, or has another size than what was read, comes back as it is. O(words).
[[nodiscard]] Page with_words(Page page, const FoundWords& found);

/// What the worker that reads answers: words, or one line that says why there are none.
[[nodiscard]] Result<std::vector<std::byte>> answer_of(const Result<FoundWords>& found);

/// The words, or the worker's line, escaped and cut. Any bytes may be given. Fails unless every box
/// and place is within a picture of this size. O(bytes).
[[nodiscard]] Result<FoundWords> words_of(std::span<const std::byte> answer, int width, int height);

}  // namespace touchline
