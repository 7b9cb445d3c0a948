// Tesseract, for the one program that it is loaded into.
// Threads: one reader, one thread; OMP_THREAD_LIMIT must have been 1 when the program began.
#pragma once

#include "app/decode/found_words.h"
#include "app/decode/reading_order.h"

#include <memory>

namespace tesseract {
class TessBaseAPI;
}

namespace touchline {

class WordReader {
  public:
    /// Reads the data of the languages from the system's files, once for all. Fails with one line
    /// where they are missing.
    [[nodiscard]] static Result<WordReader> load(const ReadingOrder& order);

    /// The words that can be believed (word_gate.h); none is no error. Opens no file. Takes up to
    /// some seconds, more for a photo than for a page of text.
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
