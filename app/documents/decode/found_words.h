// Words that were read in the pixels of a page without text of its own, and how they join the page.
// Reading takes seconds, so a page is felt first and gets its labels when they are ready:
//
//   if (needs_reading(page)) ... words = read_words(page.picture) (opening.h) ...
//   page = with_words(std::move(page), *words);
//
// Threads: values and pure functions.
#pragma once

#include "app/documents/decode/page.h"
#include "config/types/result.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

enum class WrittenLanguage : std::uint8_t { english, german, french, spanish, italian };

struct ReadingOrder {
    /// There is at least one; the likeliest comes first. Each further one takes as long again as
    /// the first, so ask only for those that the visitor speaks.
    std::vector<WrittenLanguage> languages{WrittenLanguage::english};
};

/// "English"; a name for people.
[[nodiscard]] std::string_view name_of(WrittenLanguage language);

/// The language of an ISO 639 code ("de"); English if it cannot be read.
[[nodiscard]] WrittenLanguage written_language(std::string_view code);

/// The code in tesseract's data: "eng".
[[nodiscard]] std::string_view code_of(WrittenLanguage language);

/// What the worker that reads gets on its command line; reading_order_in() reads the same back.
[[nodiscard]] std::vector<std::string> arguments_of(const ReadingOrder& order);
[[nodiscard]] Result<ReadingOrder> reading_order_in(std::span<const std::string> arguments);

struct FoundWords {
    int width = 0;  // of the picture that was read, in pixels
    int height = 0;
    std::vector<WordBox> boxes;  // one for each word, within the picture
    Area area;                   // with the picture's proportions
    std::vector<Label> labels;   // one per line of close words; within area
};

/// True if there is something to read: the page has pixels, no known words in them, and no lines
/// that the file itself wants felt.
[[nodiscard]] bool needs_reading(const Page& page);

/// Adds the words to the page as labels, and their boxes as parts not to be felt. Returns the page
/// unchanged if it needs no reading, or has another size than the picture that was read. O(words).
[[nodiscard]] Page with_words(Page page, const FoundWords& found);

/// The answer of the worker that reads: words, or one line that says why there are none.
[[nodiscard]] Result<std::vector<std::byte>> answer_of(const Result<FoundWords>& found);

/// Returns the words, or fails with the worker's line, escaped and cut. The bytes may be anything.
/// Fails unless every box and place is within a picture of this size. O(bytes).
[[nodiscard]] Result<FoundWords> words_of(std::span<const std::byte> answer, int width, int height);

}  // namespace touchline
