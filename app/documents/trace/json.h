// Writes JSON for reports.
// Threads: pure functions.
#pragma once

#include <string>
#include <string_view>

namespace touchline {

/// The text as a JSON string, quotes included.
[[nodiscard]] std::string json_string(std::string_view text);

/// The shortest number that reads back to the same bits; null if it is not finite.
[[nodiscard]] std::string json_number(double value);

}  // namespace touchline
