// Text from outside (paths, ids, messages of libraries) made fit for an Error's single line.
// Threads: pure functions. O(n).
#pragma once

#include <string>
#include <string_view>

namespace touchline {

/// The text without control characters (each becomes a blank) and cut after 200 bytes, with "..."
/// where something was cut. Never splits a UTF-8 character.
[[nodiscard]] std::string one_line(std::string_view text);

}  // namespace touchline
