#include "app/documents/decode/one_line.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace touchline {
namespace {

constexpr std::size_t max_bytes = 200;

bool is_control(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7f;
}

bool is_continuation(char c) {
    return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U;
}

/// The number of bytes up to `most` that ends no character early.
std::size_t cut_at(std::string_view text, std::size_t most) {
    std::size_t kept = std::min(text.size(), most);
    if (kept < text.size())
        while (kept > 0 && is_continuation(text[kept])) --kept;
    return kept;
}

/// U+200B ... U+200F, U+202A ... U+202E, U+2066 ... U+2069: nobody hears these marks, but text can
/// hide behind them.
bool is_invisible_mark(std::string_view text, std::size_t at) {
    if (!text.substr(at).starts_with("\xe2") || at + 2 >= text.size()) return false;
    const auto second = static_cast<unsigned char>(text[at + 1]);
    const auto third = static_cast<unsigned char>(text[at + 2]);
    if (second == 0x80) return (third >= 0x8b && third <= 0x8f) || (third >= 0xaa && third <= 0xae);
    return second == 0x81 && third >= 0xa6 && third <= 0xa9;
}

}  // namespace

std::string one_line(std::string_view text) {
    const std::size_t kept = cut_at(text, max_bytes);
    std::string line(text.substr(0, kept));
    std::replace_if(line.begin(), line.end(), is_control, ' ');
    if (kept < text.size()) line += "...";
    return line;
}

std::string one_spaced(std::string_view text, std::size_t most_bytes) {
    std::string line;
    bool is_after_blank = true;
    for (std::size_t at = 0; at < text.size() && line.size() <= most_bytes;) {
        const bool is_mark = is_invisible_mark(text, at);
        const bool is_blank = is_mark || is_control(text[at]) || text[at] == ' ';
        if (!is_blank) line += text[at];
        if (is_blank && !is_after_blank) line += ' ';
        is_after_blank = is_blank;
        at += is_mark ? 3 : 1;
    }
    if (line.size() > most_bytes) {
        line.resize(cut_at(line, most_bytes));
        line += "...";
    }
    if (line.ends_with(' ')) line.pop_back();
    return line;
}

std::string json_string(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (static_cast<unsigned char>(c) < 0x20) {
            out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        } else {
            out += c;
        }
    }
    return out + "\"";
}

std::string json_number(double value) {
    return std::isfinite(value) ? fmt::format("{}", value) : "null";
}

}  // namespace touchline
