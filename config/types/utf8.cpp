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

}  // namespace touchline
