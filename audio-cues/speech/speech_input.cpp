#include "audio-cues/speech/speech_input.h"

#include "config/types/utf8.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace touchline {
namespace {

struct Measured {
    double setting;
    double per_minute;  // words of English, including pauses between sentences
};

constexpr std::array<Measured, 11> by_rate{{{80, 102.3},
                                            {100, 121.3},
                                            {120, 146.4},
                                            {140, 172.7},
                                            {160, 198.3},
                                            {180, 225.0},
                                            {200, 251.1},
                                            {220, 277.4},
                                            {240, 305.6},
                                            {260, 334.6},
                                            {280, 363.8}}};
// At the engine's slowest rate; slowest first.
constexpr std::array<Measured, 7> by_gap{
    {{20, 48.7}, {16, 53.9}, {12, 60.4}, {8, 68.6}, {4, 79.5}, {2, 86.2}, {0, 102.3}}};

/// Returns the setting for `per_minute`, linear between rows; beyond them the last one.
int setting_for(double per_minute, std::span<const Measured> rows) {
    const double wanted = std::clamp(per_minute, rows.front().per_minute, rows.back().per_minute);
    std::size_t i = 1;
    while (i + 1 < rows.size() && rows[i].per_minute < wanted) ++i;
    const Measured& low = rows[i - 1];
    const Measured& high = rows[i];
    const double t = (wanted - low.per_minute) / (high.per_minute - low.per_minute);
    return static_cast<int>(std::lround(low.setting + t * (high.setting - low.setting)));
}

bool is_control(std::string_view character) {
    const auto first = static_cast<unsigned char>(character[0]);
    if (character.size() == 1) return first < 0x20U || first == 0x7FU;
    return character.size() == 2 && first == 0xC2U &&
           static_cast<unsigned char>(character[1]) < 0xA0U;
}

constexpr std::string_view ellipsis = "\u2026";
constexpr std::string_view hard_blank = "\u00a0";
constexpr std::string_view thin_blank = "\u202f";

/// Signs that may stand before a word without hiding any of it.
constexpr std::array<std::string_view, 6> opening{"\u201c", "\u201e", "\u00ab", "\"", "(", "'"};

/// Signs beyond ASCII that separate words.
constexpr std::array<std::string_view, 9> parting{
    "\u2019", "\u201c", "\u201d", "\u201e", "\u00ab", "\u00bb", ellipsis, hard_blank, thin_blank};

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

EngineRate engine_rate(std::size_t step, double pace) {
    const double wanted =
        speech_rates_per_minute[std::min(step, speech_rates_per_minute.size() - 1)];
    const double as_english = pace >= 0.5 && pace <= 2.0 ? wanted / pace : wanted;
    return {setting_for(as_english, by_rate), setting_for(as_english, by_gap)};
}

std::string plain_text(std::string_view text) {
    std::string plain;
    while (!text.empty()) {
        const std::size_t size = utf8_character_bytes(text);
        const auto character = text.substr(0, std::max<std::size_t>(size, 1));
        const bool is_plain = size > 0 && !is_control(character);
        if (plain.size() + character.size() > longest_speech_bytes) break;
        plain += is_plain ? character : std::string_view(" ");
        text.remove_prefix(character.size());
    }
    return plain;
}

std::vector<Respelling> respellings_of(std::string_view table) {
    std::vector<Respelling> rows;
    while (!table.empty()) {
        const auto end = std::min(table.find(';'), table.size());
        const auto line = table.substr(0, end);
        table.remove_prefix(std::min(end + 1, table.size()));
        const auto sign = line.find('=');
        if (sign == std::string_view::npos) continue;
        auto written = trimmed(line.substr(0, sign), " ");
        auto spoken = trimmed(line.substr(sign + 1), " ");
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
