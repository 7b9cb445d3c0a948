#include "app/documents/sticks/names.h"

#include "config/types/utf8.h"

#include <algorithm>
#include <cstdlib>

#include <unicode/uchar.h>
#include <unicode/unistr.h>
#include <unicode/utf8.h>

namespace touchline {
namespace {

constexpr std::string_view replacement = "\xef\xbf\xbd";  // U+FFFD
constexpr std::string_view ellipsis = "\xe2\x80\xa6";     // U+2026

std::string escaped(char byte) {
    constexpr std::string_view digits = "0123456789abcdef";
    const auto value = static_cast<unsigned char>(byte);
    return {'\\', 'x', digits[value >> 4U], digits[value & 0xfU]};
}

std::size_t columns_of(UChar32 character) {
    const int width = u_getIntPropertyValue(character, UCHAR_EAST_ASIAN_WIDTH);
    return width == U_EA_FULLWIDTH || width == U_EA_WIDE ? 2 : 1;
}

struct Glyph {
    std::string text;
    std::size_t columns = 1;
};

Glyph glyph_of(const NameCharacter& piece) {
    if (piece.code < 0) return {escaped(piece.bytes[0]), 4};
    if (is_invisible(piece.code)) return {std::string(replacement), 1};
    if (u_isUWhiteSpace(piece.code) != 0) return {" ", 1};
    return {std::string(piece.bytes), columns_of(piece.code)};
}

}  // namespace

std::string shown_name(std::string_view name) {
    std::string text;
    std::string kept;  // the longest beginning that leaves a column for the ellipsis
    std::size_t columns = 0;
    int piled = 0;
    while (!name.empty()) {
        const NameCharacter piece = first_character(name);
        name.remove_prefix(piece.bytes.size());
        const bool is_piled =
            piece.code >= 0 && is_mark(piece.code) && !is_invisible(piece.code) && columns > 0;
        piled = is_piled ? piled + 1 : 0;
        if (piled > most_piled_marks) continue;
        const Glyph glyph = glyph_of(piece);
        columns += is_piled ? 0 : glyph.columns;
        if (columns > shown_columns) return kept + std::string(ellipsis);
        text += glyph.text;
        if (columns < shown_columns) kept = text;
    }
    return text;
}

std::string sort_key(const icu::Collator& collator, std::string_view text) {
    const auto units =
        icu::UnicodeString::fromUTF8({text.data(), static_cast<std::int32_t>(text.size())});
    const std::int32_t bytes = collator.getSortKey(units, nullptr, 0);
    std::string key(static_cast<std::size_t>(bytes), '\0');
    collator.getSortKey(units, reinterpret_cast<std::uint8_t*>(key.data()), bytes);
    return key;
}

NaturalOrder::NaturalOrder() {
    UErrorCode error = U_ZERO_ERROR;
    collator_.reset(icu::Collator::createInstance(icu::Locale::getRoot(), error));
    if (U_SUCCESS(error) != 0) collator_->setAttribute(UCOL_NUMERIC_COLLATION, UCOL_ON, error);
    if (U_FAILURE(error) != 0) std::abort();
    (void)key_of("warm 1");
}

std::string NaturalOrder::key_of(std::string_view name) const {
    // The key ends with a zero byte, so names that a reader takes for equal follow by their bytes.
    return sort_key(*collator_, name).append(name);
}

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
