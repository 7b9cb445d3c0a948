#include "app/documents/decode/one_line.h"
#include "app/documents/decode/opening.h"
#include "config/types/utf8.h"

#include <array>
#include <cstdint>

namespace touchline {
namespace {

constexpr std::size_t longest_title = 200;
constexpr std::size_t longest_description = 4000;

void append_utf8(std::string& text, std::uint32_t code) {
    const auto byte = [&text](std::uint32_t value) { text += static_cast<char>(value); };
    if (code < 0x80U) return byte(code);
    if (code < 0x800U) {
        byte(0xc0U | code >> 6U);
    } else if (code < 0x10000U) {
        byte(0xe0U | code >> 12U);
        byte(0x80U | (code >> 6U & 0x3fU));
    } else {
        byte(0xf0U | code >> 18U);
        byte(0x80U | (code >> 12U & 0x3fU));
        byte(0x80U | (code >> 6U & 0x3fU));
    }
    byte(0x80U | (code & 0x3fU));
}

enum class Utf16 : std::uint8_t { none, little, big };

/// Detects UTF-16 by its mark; without one, by the zero in every Latin character.
Utf16 utf16_of(std::string_view bytes) {
    if (bytes.starts_with("\xff\xfe")) return Utf16::little;
    if (bytes.starts_with("\xfe\xff")) return Utf16::big;
    std::array<std::size_t, 2> zeros{};  // at even and at odd places
    for (std::size_t at = 0; at < bytes.size(); ++at)
        if (bytes[at] == '\0') ++zeros.at(at % 2);
    if (bytes.size() % 2 != 0 || 4 * (zeros[0] + zeros[1]) < bytes.size()) return Utf16::none;
    if (zeros[0] == 0) return Utf16::little;
    return zeros[1] == 0 ? Utf16::big : Utf16::none;
}

/// Decodes what Windows calls "Unicode". Drops lone surrogates.
std::string of_utf16(std::string_view bytes, Utf16 order) {
    const std::size_t low = order == Utf16::big ? 1 : 0;
    const bool has_mark = bytes.starts_with("\xfe\xff") || bytes.starts_with("\xff\xfe");
    const auto unit = [&](std::size_t at) -> std::uint32_t {
        return static_cast<unsigned char>(bytes[at + low]) |
               static_cast<unsigned>(static_cast<unsigned char>(bytes[at + 1 - low])) << 8U;
    };
    std::string text;
    for (std::size_t at = has_mark ? 2 : 0; at + 1 < bytes.size(); at += 2) {
        std::uint32_t code = unit(at);
        const bool is_first = code >= 0xd800U && code < 0xdc00U;
        const std::uint32_t next = is_first && at + 3 < bytes.size() ? unit(at + 2) : 0U;
        if (next >= 0xdc00U && next < 0xe000U) {
            code = 0x10000U + ((code - 0xd800U) << 10U) + (next - 0xdc00U);
            at += 2;
        } else if (code >= 0xd800U && code < 0xe000U) {
            code = '?';
        }
        append_utf8(text, code);
    }
    return text;
}

/// Decodes what Windows calls "ANSI" in western Europe: code page 1252.
std::string of_windows_1252(std::string_view bytes) {
    constexpr std::array<std::uint16_t, 32> from_80{
        0x20ac, '?',    0x201a, 0x0192, 0x201e, 0x2026, 0x2020, 0x2021, 0x02c6, 0x2030, 0x0160,
        0x2039, 0x0152, '?',    0x017d, '?',    '?',    0x2018, 0x2019, 0x201c, 0x201d, 0x2022,
        0x2013, 0x2014, 0x02dc, 0x2122, 0x0161, 0x203a, 0x0153, '?',    0x017e, 0x0178};
    std::string text;
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        append_utf8(text, byte >= 0x80U && byte < 0xa0U ? from_80[byte - 0x80U] : byte);
    }
    return text;
}

/// The text of an editor, in UTF-8; empty for a picture or program that somebody named .txt.
std::string text_in(std::string_view bytes) {
    if (bytes.size() > max_side_car_bytes) return {};
    if (const Utf16 order = utf16_of(bytes); order != Utf16::none) {
        std::string text = of_utf16(bytes, order);
        return text.find('\0') == std::string::npos ? text : std::string();
    }
    if (bytes.find('\0') != std::string_view::npos) return {};
    return is_utf8(bytes) ? std::string(bytes) : of_windows_1252(bytes);
}

}  // namespace

void tell(std::string_view bytes, TactileMap& told) {
    const std::string text = text_in(bytes);
    std::string_view side_car = text;
    if (side_car.starts_with("\xef\xbb\xbf")) side_car.remove_prefix(3);
    const auto first = side_car.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return;
    side_car.remove_prefix(first);
    const auto end = side_car.find_first_of("\r\n");
    const std::string line = one_spaced(side_car.substr(0, end), longest_description);
    const std::string rest = end == std::string_view::npos
                                 ? std::string()
                                 : one_spaced(side_car.substr(end), longest_description);
    told.description = rest.empty() ? line : rest;
    if (!rest.empty()) told.title = one_spaced(line, longest_title);
}

}  // namespace touchline
