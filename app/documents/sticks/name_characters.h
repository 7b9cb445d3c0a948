// Private to app/documents/sticks: the characters of a name of any bytes, and what each means to a
// reader. Threads: pure functions. Each is O(1) except without_ending().
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace touchline {

/// The most accents kept on one letter.
inline constexpr int most_piled_marks = 3;

/// One character of a name, or one byte that is not part of a character.
struct NameCharacter {
    std::string_view bytes;
    std::int32_t code = -1;  // -1: no character
};

/// The text must not be empty.
[[nodiscard]] NameCharacter first_character(std::string_view text);

/// True for control, format, private and unassigned characters, and line separators.
[[nodiscard]] bool is_invisible(std::int32_t code);

[[nodiscard]] bool is_mark(std::int32_t code);
[[nodiscard]] bool is_letter(std::int32_t code);
[[nodiscard]] bool is_capital(std::int32_t code);

/// True for a digit or another sign for a number, such as a half.
[[nodiscard]] bool is_number(std::int32_t code);
[[nodiscard]] bool is_apostrophe(std::int32_t code);

/// 0 ... 9 for a decimal digit of any script.
[[nodiscard]] std::optional<int> digit_of(std::int32_t code);

/// The name without its ending, such as ".jpg": up to five letters and digits after the last dot,
/// with at least one letter ("10.15" has no ending).
[[nodiscard]] std::string_view without_ending(std::string_view name);

}  // namespace touchline
