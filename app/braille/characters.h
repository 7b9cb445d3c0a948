// The characters of a text one by one, and what may be written in place of one that a braille table
// lacks. Threads: pure functions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// What becomes of a character in braille.
enum class BrailleKind : unsigned char {
    written,
    blank,   // of any width; a control character too
    nothing  // a mark that nobody sees
};

/// A letter and an accent that follows it are one, if Unicode has them as one.
struct TextCharacter {
    char32_t code = 0;
    BrailleKind kind = BrailleKind::written;
    int first = 0;  // its place among the characters of the text
};

struct TextCharacters {
    std::vector<TextCharacter> characters;
    int count = 0;  // code points of the text, and bytes that are part of none
};

/// A byte that is not UTF-8 is a question mark. O(n).
[[nodiscard]] TextCharacters characters_of(std::string_view text);

/// Returns what may stand for the character, the nearest first; each may be several characters, and
/// the last may be empty: an accent that only piles up. Never empty itself, and ends with the
/// question mark if nothing is like it.
[[nodiscard]] std::vector<std::u32string> likes_of(char32_t code);

}  // namespace touchline
