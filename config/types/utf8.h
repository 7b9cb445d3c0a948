// Text from outside: strict UTF-8, one harmless line of it, and the number that it is.
// Threads: pure functions.
#pragma once

#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

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

/// Capitals of ASCII become small; other bytes stay as they are, whatever the locale. O(n).
[[nodiscard]] inline std::string in_small_letters(std::string_view text) {
    std::string made(text);
    for (char& c : made)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return made;
}

/// The number that the whole text is; nothing if it is none, or beyond a Number. O(n).
template <class Number>
[[nodiscard]] std::optional<Number> number_in(std::string_view text) {
    Number number{};
    const char* const end = text.data() + text.size();
    const auto [at, error] = std::from_chars(text.data(), end, number);
    return error == std::errc() && at == end ? std::optional(number) : std::nullopt;
}

/// The same for a number from `least` to `most`; NaN is none.
template <class Number>
[[nodiscard]] std::optional<Number> number_in(std::string_view text, Number least, Number most) {
    const auto number = number_in<Number>(text);
    return number && *number >= least && *number <= most ? number : std::nullopt;
}

}  // namespace touchline
