// The words in a picture, read by a worker that can do nothing else (touchline-read).
// Threads: any, each call by itself. A call waits for its worker, at most its deadline
// (WorkerKind::ocr), so no thread that draws or speaks should make it.
#pragma once

#include "app/documents/decode/found_words.h"

namespace touchline {

/// The credible words; finding none is no error. Fails with one line: why, and what follows from
/// it. The picture holds at least one pixel.
[[nodiscard]] Result<FoundWords> read_words(const Picture& picture, const ReadingOrder& order = {});

}  // namespace touchline
