// Reads words in the pixels of a page without text of its own, by the worker of app/decode.
// Threads: the reader is called from any, one call at a time; the language may change meanwhile.
#pragma once

#include "app/decode/reading_order.h"
#include "app/loading/kiosk_stages.h"

#include <atomic>
#include <memory>

namespace touchline {

/// Reads in the language that `language` holds at the call. If reading fails, or finds nothing, the
/// page stays as it was felt.
[[nodiscard]] PageReader page_reader(std::shared_ptr<const std::atomic<WrittenLanguage>> language);

}  // namespace touchline
