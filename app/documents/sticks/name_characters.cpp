#include "app/documents/sticks/name_characters.h"

#include "config/types/utf8.h"

#include <algorithm>

#include <unicode/uchar.h>
#include <unicode/utf8.h>

namespace touchline {

NameCharacter first_character(std::string_view text) {
    const std::size_t bytes = utf8_character_bytes(text);
    if (bytes == 0) return {text.substr(0, 1), -1};
    UChar32 code = 0;
    std::size_t next = 0;
    U8_NEXT_UNSAFE(text, next, code);
    return {text.substr(0, bytes), code};
}

bool is_invisible(std::int32_t code) {
    switch (u_charType(code)) {
        case U_CONTROL_CHAR:
        case U_FORMAT_CHAR:  // bidi overrides, zero-width characters, tags
        case U_LINE_SEPARATOR:
        case U_PARAGRAPH_SEPARATOR:
        case U_PRIVATE_USE_CHAR:
        case U_SURROGATE:
        case U_UNASSIGNED:
            return true;
        default:
            return u_hasBinaryProperty(code, UCHAR_DEFAULT_IGNORABLE_CODE_POINT) != 0;
    }
}

bool is_mark(std::int32_t code) {
    return (U_MASK(u_charType(code)) & U_GC_M_MASK) != 0;
}

bool is_letter(std::int32_t code) {
    return (U_MASK(u_charType(code)) & U_GC_L_MASK) != 0;
}

bool is_capital(std::int32_t code) {
    return u_charType(code) == U_UPPERCASE_LETTER;
}

bool is_number(std::int32_t code) {
    return (U_MASK(u_charType(code)) & U_GC_N_MASK) != 0;
}

bool is_apostrophe(std::int32_t code) {
    return code == U'\'' || code == 0x2019;
}

std::optional<int> digit_of(std::int32_t code) {
    const std::int32_t value = u_charDigitValue(code);
    if (value < 0) return std::nullopt;
    return value;
}

std::string_view without_ending(std::string_view name) {
    constexpr std::size_t longest_ending = 5;
    const std::size_t dot = name.rfind('.');
    if (dot == std::string_view::npos || dot == 0) return name;
    const std::string_view ending = name.substr(dot + 1);
    const auto is_plain_letter = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    };
    const bool is_ending = ending.size() <= longest_ending &&
                           std::ranges::any_of(ending, is_plain_letter) &&
                           std::ranges::all_of(ending, [&is_plain_letter](char c) {
                               return (c >= '0' && c <= '9') || is_plain_letter(c);
                           });
    return is_ending ? name.substr(0, dot) : name;
}

}  // namespace touchline
