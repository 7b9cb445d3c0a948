// Text from outside (paths, ids, messages of libraries) made fit for an Error's single line.
// Threads: pure functions. O(n).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace touchline {

/// The text without control characters (each becomes a blank), cut after 200 bytes. "..." marks a
/// cut. Never splits a UTF-8 character.
[[nodiscard]] std::string one_line(std::string_view text);

/// For a longer text (a description): control characters and marks that turn the direction of
/// writing become blanks, and runs of blanks become one. Cuts as one_line() does, after
/// `most_bytes`.
[[nodiscard]] std::string one_spaced(std::string_view text, std::size_t most_bytes);

}  // namespace touchline
