// What reads words in the pixels of a page that has no text of its own: the worker of app/decode.
// Threads: the reader is called from any, one call at a time; the language may change meanwhile.
#pragma once

#include "app/decode/reading_order.h"
#include "app/loading/kiosk_stages.h"

#include <atomic>
#include <memory>

namespace touchline {

/// In what `language` is when it is called. Where reading fails, or finds nothing, the page stays
/// as it was felt.
[[nodiscard]] PageReader page_reader(std::shared_ptr<const std::atomic<WrittenLanguage>> language);

}  // namespace touchline
