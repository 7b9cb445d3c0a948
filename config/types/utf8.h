// UTF-8 strictly by RFC 3629: no overlong forms, no surrogates, nothing above U+10FFFF. Code that
// draws or speaks text need not cope with anything else.
// Threads: pure functions.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace touchline {

/// Returns the number of bytes of the text's first character; 0 if it does not begin with one.
/// O(1).
[[nodiscard]] std::size_t utf8_character_bytes(std::string_view text);

/// O(n).
[[nodiscard]] bool is_utf8(std::string_view text);

/// Returns the text with '?' for every byte that belongs to no character. O(n).
[[nodiscard]] std::string utf8_of(std::string_view text);

}  // namespace touchline
