#include "app/braille/characters.h"

#include "config/types/utf8.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include <unicode/uchar.h>
#include <unicode/unorm2.h>
#include <unicode/utf8.h>

namespace touchline {
namespace {

struct Like {
    char32_t code;
    const char32_t* like;
};

/// Signs that tables of one language or another lack. U+2824 is the cell of the hyphen, which
/// liblouis's Italian table lacks.
constexpr std::array likes{
    Like{U'-', U"\u2824"},      Like{U'_', U"-"},       Like{U'\u2010', U"-"},
    Like{U'\u2011', U"-"},      Like{U'\u2012', U"-"},  Like{U'\u2013', U"-"},
    Like{U'\u2014', U"-"},      Like{U'\u2015', U"-"},  Like{U'\u2212', U"-"},
    Like{U'\u00b7', U"-"},      Like{U'\u2022', U"-"},  Like{U'\u2018', U"'"},
    Like{U'\u2019', U"'"},      Like{U'\u201b', U"'"},  Like{U'\u2032', U"'"},
    Like{U'\u00b4', U"'"},      Like{U'`', U"'"},       Like{U'\u201c', U"\""},
    Like{U'\u201d', U"\""},     Like{U'\u201e', U"\""}, Like{U'\u201f', U"\""},
    Like{U'\u00ab', U"\""},     Like{U'\u00bb', U"\""}, Like{U'\u2039', U"\""},
    Like{U'\u203a', U"\""},     Like{U'\u2033', U"\""}, Like{U'\u2026', U"..."},
    Like{U'\u00d7', U"x"},      Like{U'\u00e6', U"ae"}, Like{U'\u00c6', U"Ae"},
    Like{U'\u0153', U"oe"},     Like{U'\u0152', U"Oe"}, Like{U'\u00f8', U"o"},
    Like{U'\u00d8', U"O"},      Like{U'\u0142', U"l"},  Like{U'\u0141', U"L"},
    Like{U'\u0111', U"d"},      Like{U'\u0110', U"D"},  Like{U'\u00df', U"ss"},
    Like{U'\u1e9e', U"SS"},     Like{U'\u0131', U"i"},  Like{U'\u20ac', U"EUR"},
    Like{U'\u00b5', U"\u03bc"},
};

UChar32 as_icu(char32_t code) {
    return static_cast<UChar32>(code);
}

std::uint32_t category_of(char32_t code) {
    return U_MASK(u_charType(as_icu(code)));
}

bool is_accent(char32_t code) {
    return (category_of(code) & U_GC_M_MASK) != 0;
}

BrailleKind kind_of(char32_t code) {
    if (u_isUWhiteSpace(as_icu(code)) != 0 || code == U'\u2800') return BrailleKind::blank;
    if ((category_of(code) & U_GC_CC_MASK) != 0) return BrailleKind::blank;
    if ((category_of(code) & U_GC_CF_MASK) != 0) return BrailleKind::nothing;
    return BrailleKind::written;
}

const UNormalizer2* composer() {
    UErrorCode error = U_ZERO_ERROR;
    const UNormalizer2* const found = unorm2_getNFCInstance(&error);
    return U_SUCCESS(error) != 0 ? found : nullptr;
}

/// Takes the first character off the text.
char32_t take_character(std::string_view& text) {
    const std::size_t bytes = utf8_character_bytes(text);
    char32_t code = U'?';
    if (bytes > 0) {
        std::int32_t at = 0;
        UChar32 read = 0;
        U8_NEXT_UNSAFE(text.data(), at, read);
        code = static_cast<char32_t>(read);
    }
    text.remove_prefix(std::max(bytes, std::size_t{1}));
    return code;
}

/// Returns the letter without its accents; 0 if it has none.
char32_t bare_letter(char32_t code) {
    const UNormalizer2* const normalizer = composer();
    if (normalizer == nullptr) return 0;
    std::array<UChar, 32> apart{};
    UErrorCode error = U_ZERO_ERROR;
    const std::int32_t units = unorm2_getDecomposition(
        normalizer, as_icu(code), apart.data(), static_cast<std::int32_t>(apart.size()), &error);
    if (U_FAILURE(error) != 0 || units <= 0) return 0;
    const bool is_pair = units > 1 && U16_IS_LEAD(apart[0]) && U16_IS_TRAIL(apart[1]);
    return is_pair ? static_cast<char32_t>(U16_GET_SUPPLEMENTARY(apart[0], apart[1])) : apart[0];
}

}  // namespace

TextCharacters characters_of(std::string_view text) {
    TextCharacters result;
    while (!text.empty()) {
        const char32_t code = take_character(text);
        const int at = result.count++;
        if (is_accent(code) && !result.characters.empty() && composer() != nullptr) {
            TextCharacter& last = result.characters.back();
            const UChar32 both = unorm2_composePair(composer(), as_icu(last.code), as_icu(code));
            if (both >= 0) {
                last.code = static_cast<char32_t>(both);
                continue;
            }
        }
        result.characters.push_back({code, kind_of(code), at});
    }
    return result;
}

std::vector<std::u32string> likes_of(char32_t code) {
    std::vector<std::u32string> found;
    const auto* const known = std::ranges::find(likes, code, &Like::code);
    if (known != likes.end()) {
        found.emplace_back(known->like);
        // The like of the like: a long dash is a hyphen, and that one a cell.
        const auto* const next = std::ranges::find(likes, known->like[0], &Like::code);
        if (next != likes.end() && known->like[1] == 0) found.emplace_back(next->like);
    }
    if (const char32_t letter = bare_letter(code); letter != 0) found.push_back({letter});
    found.emplace_back(is_accent(code) ? U"" : U"?");
    return found;
}

}  // namespace touchline
