// Tesseract, for the only program that loads it.
// Threads: one reader, one thread; OMP_THREAD_LIMIT must have been 1 when the program began.
#pragma once

#include "app/decode/found_words.h"

#include <memory>

namespace tesseract {
class TessBaseAPI;
}

namespace touchline {

class WordReader {
  public:
    /// Reads the languages' data from the system's files, once. Fails with one line if they are
    /// missing.
    [[nodiscard]] static Result<WordReader> load(const ReadingOrder& order);

    /// The credible words (word_gate.h); finding none is no error. Opens no file. Takes up to some
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
