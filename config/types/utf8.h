// Text from outside: strict UTF-8, and one harmless line of it. Threads: pure functions.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace touchline {

// UTF-8 is strictly that of RFC 3629: no overlong forms, no surrogates, nothing above U+10FFFF.
// Code that draws or speaks text need not cope with anything else.

/// Returns the number of bytes of the text's first character; 0 if it does not begin with one.
/// O(1).
[[nodiscard]] std::size_t utf8_character_bytes(std::string_view text);

/// O(n).
[[nodiscard]] bool is_utf8(std::string_view text);

/// Returns the text with '?' for every byte that belongs to no character. O(n).
[[nodiscard]] std::string utf8_of(std::string_view text);

/// Makes any text one harmless line for a terminal or a log; file names and texts from devices and
/// users go through here before a line is printed. Puts a blank for every control character
/// (newline, ESC, the 8-bit ones), separator of lines, and mark that turns the direction of writing
/// or shows nothing; and '?' for what is not UTF-8. O(n).
[[nodiscard]] std::string plain_line(std::string_view text);

}  // namespace touchline
