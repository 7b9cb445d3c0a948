// The languages in which words are looked for in a picture.
// Threads: values and pure functions.
#pragma once

#include "config/types/result.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

enum class WrittenLanguage : std::uint8_t { english, german, french, spanish, italian };

struct ReadingOrder {
    /// At least one, the likeliest first. Each further one takes as long again as the first, so ask
    /// only for those that the visitor speaks.
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

}  // namespace touchline
