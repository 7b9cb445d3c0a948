#include "app/sticks/names.h"

#include "config/types/utf8.h"

#include <algorithm>

#include <unicode/uchar.h>
#include <unicode/utf8.h>

namespace touchline {
namespace {

constexpr std::string_view replacement = "\xef\xbf\xbd";  // U+FFFD
constexpr std::string_view ellipsis = "\xe2\x80\xa6";     // U+2026
constexpr int most_piled_marks = 3;

/// One character of a name, or one byte that belongs to none.
struct Piece {
    std::string_view bytes;
    UChar32 character = -1;  // -1: no character
};

/// The text is not empty.
Piece first_piece(std::string_view text) {
    const std::size_t bytes = utf8_character_bytes(text);
    if (bytes == 0) return {text.substr(0, 1), -1};
    UChar32 character = 0;
    std::size_t next = 0;
    U8_NEXT_UNSAFE(text, next, character);
    return {text.substr(0, bytes), character};
}

std::string escaped(char byte) {
    constexpr std::string_view digits = "0123456789abcdef";
    const auto value = static_cast<unsigned char>(byte);
    return {'\\', 'x', digits[value >> 4U], digits[value & 0xfU]};
}

bool is_invisible(UChar32 character) {
    switch (u_charType(character)) {
        case U_CONTROL_CHAR:
        case U_FORMAT_CHAR:  // bidi overrides, zero-width characters, tags
        case U_LINE_SEPARATOR:
        case U_PARAGRAPH_SEPARATOR:
        case U_PRIVATE_USE_CHAR:
        case U_SURROGATE:
        case U_UNASSIGNED:
            return true;
        default:
            return u_hasBinaryProperty(character, UCHAR_DEFAULT_IGNORABLE_CODE_POINT) != 0;
    }
}

bool is_mark(UChar32 character) {
    return (U_MASK(u_charType(character)) & U_GC_M_MASK) != 0;
}

bool is_letter(UChar32 character) {
    return (U_MASK(u_charType(character)) & U_GC_L_MASK) != 0;
}

bool is_digit(UChar32 character) {
    return (U_MASK(u_charType(character)) & U_GC_N_MASK) != 0;
}

bool is_apostrophe(UChar32 character) {
    return character == U'\'' || character == 0x2019;
}

std::size_t columns_of(UChar32 character) {
    const int width = u_getIntPropertyValue(character, UCHAR_EAST_ASIAN_WIDTH);
    return width == U_EA_FULLWIDTH || width == U_EA_WIDE ? 2 : 1;
}

/// Text that is as wide as it says.
struct Glyph {
    std::string text;
    std::size_t columns = 1;
};

Glyph glyph_of(const Piece& piece) {
    if (piece.character < 0) return {escaped(piece.bytes[0]), 4};
    if (is_invisible(piece.character)) return {std::string(replacement), 1};
    if (u_isUWhiteSpace(piece.character) != 0) return {" ", 1};
    return {std::string(piece.bytes), columns_of(piece.character)};
}

/// Without ".jpg": up to five letters and digits after the last dot.
std::string_view without_ending(std::string_view name) {
    constexpr std::size_t longest_ending = 5;
    const std::size_t dot = name.rfind('.');
    if (dot == std::string_view::npos || dot == 0) return name;
    const std::string_view ending = name.substr(dot + 1);
    const bool is_ending =
        ending.size() <= longest_ending && std::all_of(ending.begin(), ending.end(), [](char c) {
            return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        });
    return is_ending ? name.substr(0, dot) : name;
}

/// Words being put together for the voice.
class Speech {
  public:
    void add(const Piece& piece, bool is_before_letter) {
        const UChar32 character = piece.character;
        const bool is_invisible_mark = character >= 0 && is_invisible(character);
        if (character >= 0 && !is_invisible_mark && is_part(character, is_before_letter)) {
            text_ += piece.bytes;
            ++characters_;
            is_letter_last_ = is_letter(character) || is_mark(character);
            piled_ = is_mark(character) ? piled_ + 1 : 0;
        } else if (!(character >= 0 && is_mark(character))) {
            end_word();
        }
    }

    [[nodiscard]] bool is_full() const { return characters_ >= spoken_characters; }

    /// Cut between words unless it is all one.
    [[nodiscard]] std::string text(bool is_cut) const {
        if (is_cut && is_letter_last_ && word_start_ > 0) return text_.substr(0, word_start_ - 1);
        return text_.ends_with(' ') ? text_.substr(0, text_.size() - 1) : text_;
    }

  private:
    [[nodiscard]] bool is_part(UChar32 character, bool is_before_letter) const {
        if (is_mark(character)) return !is_between_words() && piled_ < most_piled_marks;
        if (is_apostrophe(character)) return is_letter_last_ && is_before_letter;
        return is_letter(character) || is_digit(character);
    }

    [[nodiscard]] bool is_between_words() const { return text_.empty() || text_.ends_with(' '); }

    void end_word() {
        is_letter_last_ = false;
        piled_ = 0;
        if (is_between_words()) return;
        text_ += ' ';
        ++characters_;
        word_start_ = text_.size();
    }

    std::string text_;
    std::size_t characters_ = 0;
    std::size_t word_start_ = 0;  // bytes before the last word
    bool is_letter_last_ = false;
    int piled_ = 0;
};

}  // namespace

std::string shown_name(std::string_view name) {
    std::string text;
    std::string kept;  // the longest beginning that leaves a column for the ellipsis
    std::size_t columns = 0;
    int piled = 0;
    while (!name.empty()) {
        const Piece piece = first_piece(name);
        name.remove_prefix(piece.bytes.size());
        const bool is_piled = piece.character >= 0 && is_mark(piece.character) &&
                              !is_invisible(piece.character) && columns > 0;
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

std::string spoken_name(std::string_view name) {
    name = without_ending(name);
    Speech speech;
    while (!name.empty() && !speech.is_full()) {
        const Piece piece = first_piece(name);
        name.remove_prefix(piece.bytes.size());
        speech.add(piece, !name.empty() && is_letter(first_piece(name).character));
    }
    const std::string text = speech.text(!name.empty());
    return text.empty() ? "a file without a name" : text;
}

std::string logged_name(std::string_view name) {
    std::string text;
    for (const char c : name) {
        const bool is_plain = c >= ' ' && c <= '~' && c != '\\';
        const std::string part = is_plain ? std::string(1, c) : escaped(c);
        if (text.size() + part.size() > logged_bytes) return text + "...";
        text += part;
    }
    return text;
}

}  // namespace touchline
