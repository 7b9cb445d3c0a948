#include "app/documents/sticks/names.h"

#include "app/documents/sticks/name_characters.h"

#include <cstdint>
#include <cstdlib>

#include <unicode/uchar.h>
#include <unicode/unistr.h>

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

}  // namespace touchline
