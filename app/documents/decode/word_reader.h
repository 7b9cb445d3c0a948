// Tesseract, for the only program that loads it, and which of the words that it sees exist. It sees
// letters everywhere in photos and line drawings, and a label that nobody wrote misleads more than
// a missing one. Threads: one reader, one thread; OMP_THREAD_LIMIT must have been 1 when the
// program began. The gate is a pure function.
#pragma once

#include "app/documents/decode/found_words.h"

#include <memory>
#include <span>
#include <string>

namespace tesseract {
class TessBaseAPI;
}

namespace touchline {
namespace decode {

struct SeenWord {
    std::string text;         // UTF-8
    double confidence = 0.0;  // 0 ... 100, tesseract's own
    WordBox box;              // within the picture
    bool begins_line = false;
};

/// The credible words in a picture of this size. Words that stand close in one line become one
/// label in their middle. O(words).
[[nodiscard]] FoundWords believed(std::span<const SeenWord> seen, int width, int height);

}  // namespace decode

class WordReader {
  public:
    /// Reads the languages' data from the system's files, once. Fails with one line if they are
    /// missing.
    [[nodiscard]] static Result<WordReader> load(const ReadingOrder& order);

    /// The credible words (believed()); finding none is no error. Opens no file. Takes up to some
    /// seconds, more for a photo than for a page of text.
    [[nodiscard]] Result<FoundWords> read(const Picture& picture);

    ~WordReader();
    WordReader(WordReader&& other) noexcept;
    WordReader& operator=(WordReader&& other) noexcept;
    WordReader(const WordReader&) = delete;
    WordReader& operator=(const WordReader&) = delete;

  private:
    explicit WordReader(std::unique_ptr<tesseract::TessBaseAPI> tesseract);

    std::unique_ptr<tesseract::TessBaseAPI> tesseract_;
};

}  // namespace touchline
