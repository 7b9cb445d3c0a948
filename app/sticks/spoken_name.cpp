#include "app/sticks/spoken_name.h"

#include "app/sticks/name_characters.h"
#include "app/sticks/name_parts.h"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>

namespace touchline {
namespace {

constexpr std::array<const char*, 31> days{
    "1st",  "2nd",  "3rd",  "4th",  "5th",  "6th",  "7th",  "8th",  "9th",  "10th", "11th",
    "12th", "13th", "14th", "15th", "16th", "17th", "18th", "19th", "20th", "21st", "22nd",
    "23rd", "24th", "25th", "26th", "27th", "28th", "29th", "30th", "31st"};

constexpr std::array<const char*, 12> months{"January",   "February", "March",    "April",
                                             "May",       "June",     "July",     "August",
                                             "September", "October",  "November", "December"};

std::string words_of(const NameMoment& moment, const Language& language) {
    const std::string day = language.text("day", days[static_cast<std::size_t>(moment.day) - 1]);
    const std::string month =
        language.text("month", months[static_cast<std::size_t>(moment.month) - 1]);
    std::string said =
        language.text("day", "{0} {1} {2}", {day, month, std::to_string(moment.year)});
    if (!moment.clock) return said;
    const auto& [hour, minute, second] = *moment.clock;
    said += fmt::format(", {}:{:02}", hour, minute);
    if (second == 0) return said;
    return said + ' ' + language.counted("count", "and {0} second", "and {0} seconds", second);
}

/// Pairs, of an odd number of digits three first: no voice takes "12 345" for twelve thousand.
std::string in_groups(std::string_view digits) {
    std::string text(digits.substr(0, digits.size() % 2 == 0 ? 2 : 3));
    for (std::size_t at = text.size(); at < digits.size(); at += 2) {
        if (text.size() + 3 > spoken_characters) break;
        text += ' ';
        text += digits.substr(at, 2);
    }
    return text;
}

bool is_year(std::string_view digits) {
    return digits.size() == 4 && (digits.starts_with("19") || digits.starts_with("20"));
}

bool is_following(char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

std::size_t characters_in(std::string_view text) {
    return text.size() - static_cast<std::size_t>(std::ranges::count_if(text, is_following));
}

/// "IMG", "xkcd": a voice would make a word of it that nobody knows. Beyond ASCII every letter is
/// taken for a vowel, for the language's voice knows better.
bool is_spelled(std::string_view word) {
    constexpr std::size_t longest = 6;
    if (word.size() > longest || std::ranges::any_of(word, is_following)) return false;
    const bool is_shouted =
        word.size() <= 3 && std::ranges::all_of(word, [](char c) { return c >= 'A' && c <= 'Z'; });
    return is_shouted || word.find_first_of("aeiouyAEIOUY") == std::string_view::npos;
}

std::string spelled(std::string_view word) {
    std::string letters;
    for (const char letter : word) {
        if (!letters.empty()) letters += ' ';
        letters += letter;
    }
    return letters;
}

/// What is said of one or more parts.
struct Said {
    std::string text;
    bool is_apart = false;  // a pause before and after it
    bool is_number = false;
    bool is_spelled = false;
};

std::string said_number(std::string_view digits, const Said* before) {
    constexpr std::size_t longest_whole = 3;
    const bool is_plain_year = is_year(digits) && (before == nullptr || !before->is_spelled);
    return digits.size() <= longest_whole || is_plain_year ? std::string(digits)
                                                           : in_groups(digits);
}

std::vector<Said> said_of(std::span<const NamePart> parts, const Language& language) {
    std::vector<Said> all;
    while (!parts.empty()) {
        const NamePart& part = parts.front();
        const Said* const before = all.empty() ? nullptr : &all.back();
        std::size_t taken = 1;
        if (const auto moment = moment_of(parts)) {
            all.push_back({words_of(*moment, language), true, true, false});
            taken = moment->parts;
        } else if (part.is_digits) {
            all.push_back({said_number(part.text, before), false, true, false});
        } else {
            const bool is_by_letter = is_spelled(part.text);
            all.push_back({is_by_letter ? spelled(part.text) : part.text, false, false,
                           is_by_letter && part.text.size() > 1});
        }
        parts = parts.subspan(taken);
    }
    return all;
}

}  // namespace

std::string spoken_name(std::string_view name, const Language& language) {
    const auto parts = parts_of_name(without_ending(name), spoken_characters);
    std::string text;
    bool is_apart = false;
    bool is_number = false;
    for (const Said& said : said_of(parts, language)) {
        const bool has_pause = is_apart || said.is_apart || (is_number && said.is_number);
        const std::string next =
            text.empty() ? said.text : text + (has_pause ? ", " : " ") + said.text;
        if (characters_in(next) > spoken_characters && !text.empty()) break;
        text = next;
        is_apart = said.is_apart;
        is_number = said.is_number;
    }
    if (text.empty()) return language.text("visit", "a file without a name");
    return text;
}

}  // namespace touchline
