#include "config/types/plain_line.h"

#include "config/types/utf8.h"

#include <algorithm>
#include <array>

namespace touchline {
namespace {

struct Range {
    std::string_view first;  // characters as UTF-8, which sorts as their numbers do
    std::string_view last;
};

/// C0 and DEL, C1, U+061C, U+200B to U+200F, U+2028 to U+202E, U+2060 to U+206F, U+FEFF, and the
/// tags from U+E0000 on.
constexpr std::array harmful{
    Range{{"\x00", 1}, "\x1f"},
    Range{"\x7f", "\x7f"},
    Range{"\xc2\x80", "\xc2\x9f"},
    Range{"\xd8\x9c", "\xd8\x9c"},
    Range{"\xe2\x80\x8b", "\xe2\x80\x8f"},
    Range{"\xe2\x80\xa8", "\xe2\x80\xae"},
    Range{"\xe2\x81\xa0", "\xe2\x81\xaf"},
    Range{"\xef\xbb\xbf", "\xef\xbb\xbf"},
    Range{"\xf3\xa0\x80\x80", "\xf3\xa0\x81\xbf"},
};

bool is_harmful(std::string_view character) {
    return std::any_of(harmful.begin(), harmful.end(), [character](const Range& range) {
        return character.size() == range.first.size() && character >= range.first &&
               character <= range.last;
    });
}

}  // namespace

std::string plain_line(std::string_view text) {
    std::string line;
    line.reserve(text.size());
    while (!text.empty()) {
        const std::size_t bytes = utf8_character_bytes(text);
        const std::string_view character = text.substr(0, bytes == 0 ? 1 : bytes);
        if (bytes == 0)
            line += '?';
        else if (is_harmful(character))
            line += ' ';
        else
            line += character;
        text.remove_prefix(character.size());
    }
    return line;
}

}  // namespace touchline
