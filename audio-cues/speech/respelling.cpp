#include "audio-cues/speech/respelling.h"

#include "config/types/utf8.h"

#include <algorithm>
#include <array>

namespace touchline {
namespace {

constexpr std::string_view ellipsis = "\u2026";
constexpr std::string_view hard_blank = "\u00a0";
constexpr std::string_view thin_blank = "\u202f";

/// Signs that may stand before a word without hiding any of it.
constexpr std::array<std::string_view, 6> opening{"\u201c", "\u201e", "\u00ab", "\"", "(", "'"};

/// Signs beyond ASCII that separate words.
constexpr std::array<std::string_view, 9> parting{
    "\u2019", "\u201c", "\u201d", "\u201e", "\u00ab", "\u00bb", ellipsis, hard_blank, thin_blank};

std::string_view trimmed(std::string_view text) {
    while (text.starts_with(' ')) text.remove_prefix(1);
    while (text.ends_with(' ')) text.remove_suffix(1);
    return text;
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

bool is_letter_or_digit(char c) {
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    return is_letter || is_digit(c) || static_cast<unsigned char>(c) >= 0x80U;
}

bool begins_with(std::string_view text, const auto& signs) {
    return std::ranges::any_of(signs, [text](auto sign) { return text.starts_with(sign); });
}

bool ends_with(std::string_view text, const auto& signs) {
    return std::ranges::any_of(signs, [text](auto sign) { return text.ends_with(sign); });
}

/// "Bourg-Est" is one word, "l’est" is two.
bool goes_on_before(std::string_view before) {
    if (before.empty() || ends_with(before, parting)) return false;
    return is_letter_or_digit(before.back()) || before.ends_with('-');
}

bool goes_on_after(std::string_view after) {
    if (after.empty() || begins_with(after, parting)) return false;
    return is_letter_or_digit(after.front()) || after.starts_with('-');
}

/// Returns whether a number or two letters come next.
bool is_before_word(std::string_view after) {
    for (const auto sign : opening)
        if (after.starts_with(sign)) after.remove_prefix(sign.size());
    if (!after.empty() && is_digit(after.front())) return true;
    int letters = 0;
    while (letters < 2 && goes_on_after(after) && after.front() != '-') {
        after.remove_prefix(std::max<std::size_t>(utf8_character_bytes(after), 1));
        ++letters;
    }
    return letters == 2;
}

bool fits(const Respelling& row, std::string_view text, std::size_t at) {
    if (!text.substr(at).starts_with(row.written)) return false;
    const auto after = text.substr(at + row.written.size());
    if (is_letter_or_digit(row.written.front()) && goes_on_before(text.substr(0, at))) return false;
    if (is_letter_or_digit(row.written.back()) && goes_on_after(after)) return false;
    return !row.is_before_word || is_before_word(after);
}

}  // namespace

std::vector<Respelling> respellings_of(std::string_view table) {
    std::vector<Respelling> rows;
    while (!table.empty()) {
        const auto end = std::min(table.find(';'), table.size());
        const auto line = table.substr(0, end);
        table.remove_prefix(std::min(end + 1, table.size()));
        const auto sign = line.find('=');
        if (sign == std::string_view::npos) continue;
        auto written = trimmed(line.substr(0, sign));
        auto spoken = trimmed(line.substr(sign + 1));
        const bool is_before = written.ends_with(ellipsis);
        if (is_before) written.remove_suffix(ellipsis.size());
        if (spoken.ends_with(ellipsis)) spoken.remove_suffix(ellipsis.size());
        if (!written.empty())
            rows.push_back({std::string(written), std::string(spoken), is_before});
    }
    return rows;
}

std::string respelled(std::string_view text, const std::vector<Respelling>& rows) {
    std::string spoken;
    for (std::size_t at = 0; at < text.size();) {
        const auto row = std::ranges::find_if(
            rows, [&](const Respelling& candidate) { return fits(candidate, text, at); });
        if (row == rows.end()) {
            spoken += text[at++];
        } else {
            spoken += row->spoken;
            at += row->written.size();
        }
    }
    return spoken;
}

}  // namespace touchline
