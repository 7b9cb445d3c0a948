// Text from outside (paths, ids, messages of libraries): made fit for an Error's single line or for
// JSON. Threads: pure functions. O(n).
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace touchline {

/// The text without control characters (each becomes a blank), cut after 200 bytes. "..." marks a
/// cut. Never splits a UTF-8 character.
[[nodiscard]] std::string one_line(std::string_view text);

/// Makes a longer text (a description) fit: control characters and marks that turn the direction of
/// writing become blanks, and runs of blanks become one. Cuts as one_line() does, after
/// `most_bytes`.
[[nodiscard]] std::string one_spaced(std::string_view text, std::size_t most_bytes);

/// The same bytes as characters; a view. O(1).
[[nodiscard]] inline std::string_view as_text(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The text as a JSON string, quotes included.
[[nodiscard]] std::string json_string(std::string_view text);

/// The shortest number that reads back to the same bits; null if it is not finite.
[[nodiscard]] std::string json_number(double value);

}  // namespace touchline
