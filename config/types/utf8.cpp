#include "config/types/utf8.h"

#include <algorithm>
#include <array>

namespace touchline {
namespace {

/// Characters by their first byte, and the range of their second byte, which is what rules out
/// overlong forms, surrogates and characters above U+10FFFF. The third and fourth bytes are 80 ...
/// BF.
struct Form {
    unsigned char first, last;
    std::size_t bytes;
    unsigned char second_first, second_last;
};

constexpr std::array<Form, 9> forms{{{0x00, 0x7f, 1, 0x00, 0x00},
                                     {0xc2, 0xdf, 2, 0x80, 0xbf},
                                     {0xe0, 0xe0, 3, 0xa0, 0xbf},
                                     {0xe1, 0xec, 3, 0x80, 0xbf},
                                     {0xed, 0xed, 3, 0x80, 0x9f},
                                     {0xee, 0xef, 3, 0x80, 0xbf},
                                     {0xf0, 0xf0, 4, 0x90, 0xbf},
                                     {0xf1, 0xf3, 4, 0x80, 0xbf},
                                     {0xf4, 0xf4, 4, 0x80, 0x8f}}};

bool is_between(char c, unsigned char first, unsigned char last) {
    const auto byte = static_cast<unsigned char>(c);
    return byte >= first && byte <= last;
}

bool has_form(std::string_view text, const Form& form) {
    if (text.size() < form.bytes || !is_between(text[0], form.first, form.last)) return false;
    if (form.bytes == 1) return true;
    const std::string_view rest = text.substr(2, form.bytes - 2);
    return is_between(text[1], form.second_first, form.second_last) &&
           std::all_of(rest.begin(), rest.end(), [](char c) { return is_between(c, 0x80, 0xbf); });
}

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

std::size_t utf8_character_bytes(std::string_view text) {
    if (text.empty()) return 0;
    const auto* const form = std::find_if(
        forms.begin(), forms.end(), [text](const Form& known) { return has_form(text, known); });
    return form == forms.end() ? 0 : form->bytes;
}

bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        const std::size_t bytes = utf8_character_bytes(text);
        if (bytes == 0) return false;
        text.remove_prefix(bytes);
    }
    return true;
}

std::string utf8_of(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const std::size_t bytes = utf8_character_bytes(text);
        result += bytes == 0 ? std::string_view("?") : text.substr(0, bytes);
        text.remove_prefix(std::max(bytes, std::size_t{1}));
    }
    return result;
}

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
