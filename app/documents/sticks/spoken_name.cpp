#include "app/documents/sticks/spoken_name.h"

#include "app/documents/sticks/names.h"

#include <algorithm>
#include <array>
#include <utility>

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

/// What cameras and telephones write before a number or a date.
constexpr std::array<std::string_view, 14> cameras{"CIMG", "DSC",  "DSCF", "DSCI", "DSCN",
                                                   "GOPR", "HPIM", "IMG",  "IMGP", "MG",
                                                   "PICT", "PXL",  "SAM",  "WIN"};

bool is_camera_mark(std::string_view word) {
    return std::ranges::count(cameras, word) > 0;
}

std::string words_of(const NameMoment& moment, const Language& language, bool is_precise) {
    const std::string day = language.text("day", days[static_cast<std::size_t>(moment.day) - 1]);
    const std::string month =
        language.text("month", months[static_cast<std::size_t>(moment.month) - 1]);
    std::string said =
        language.text("day", "{0} {1} {2}", {day, month, std::to_string(moment.year)});
    if (!moment.clock) return said;
    const auto& [hour, minute, second] = *moment.clock;
    said += fmt::format(", {}:{:02}", hour, minute);
    if (second == 0 || !is_precise) return said;
    return said + ' ' + language.counted("count", "and {0} second", "and {0} seconds", second);
}

/// Pairs; an odd number of digits begins with three. No voice takes "12 345" for twelve thousand.
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

/// True for "xkcd": a voice would make an unknown word of it. Every letter beyond ASCII counts as a
/// vowel, because the language's voice knows better.
bool is_without_vowel(std::string_view word) {
    constexpr std::size_t longest = 6;
    return word.size() <= longest && std::ranges::none_of(word, is_following) &&
           word.find_first_of("aeiouyAEIOUY") == std::string_view::npos;
}

bool is_short_in_capitals(std::string_view word) {
    constexpr std::size_t longest = 3;
    return word.size() <= longest &&
           std::ranges::all_of(word, [](char c) { return c >= 'A' && c <= 'Z'; });
}

bool has_more_than_capitals(std::string_view text) {
    while (!text.empty()) {
        const NameCharacter character = first_character(text);
        if (is_letter(character.code) && !is_capital(character.code)) return true;
        text.remove_prefix(character.bytes.size());
    }
    return false;
}

/// True for "THE CAT.JPG", as old cards and some people write it: there capitals tell nothing about
/// a word. A single word is an abbreviation ("USA.svg"), unless its ending has capitals too.
bool is_all_capitals(std::string_view name, std::span<const NamePart> parts) {
    const std::string_view stem = without_ending(name);
    const auto words = std::ranges::count_if(
        parts, [](const NamePart& part) { return !part.is_digits && !is_camera_mark(part.text); });
    if (words > 1) return !has_more_than_capitals(stem);
    return stem.size() < name.size() && !has_more_than_capitals(name);
}

std::string spelled(std::string_view word) {
    std::string letters;
    for (const char letter : word) {
        if (!letters.empty()) letters += ' ';
        letters += letter;
    }
    return letters;
}

std::string in_capitals(std::string_view text) {
    std::string capitals(text);
    for (char& c : capitals)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return capitals;
}

bool has_capital(std::string_view word) {
    return std::ranges::any_of(word, [](char c) { return c >= 'A' && c <= 'Z'; });
}

struct Said {
    std::string text;
    bool is_apart = false;  // with a pause before and after it
    bool is_number = false;
    bool is_spelled = false;
};

std::string said_number(std::string_view digits, const Said* before) {
    constexpr std::size_t longest_whole = 3;
    const bool is_plain_year = is_year(digits) && (before == nullptr || !before->is_spelled);
    return digits.size() <= longest_whole || is_plain_year ? std::string(digits)
                                                           : in_groups(digits);
}

/// True for a camera's mark, or the "P" of cameras that number their folders as well; in small
/// letters too, as some programs copy it. "Sam 2019" and "SAM 5" are people's own names.
bool is_camera(const NamePart& part, const NamePart& next) {
    constexpr std::size_t shortest = 4;
    constexpr std::size_t with_folder = 7;
    if (part.is_digits || !next.is_digits || next.text.size() < shortest) return false;
    const std::string mark = in_capitals(part.text);
    if (mark != part.text && has_capital(part.text)) return false;
    return is_camera_mark(mark) || (mark == "P" && next.text.size() == with_folder);
}

std::string_view without_zeros(std::string_view digits) {
    const auto first = digits.find_first_not_of('0');
    return first == std::string_view::npos ? digits.substr(0, 1) : digits.substr(first);
}

class Saying {
  public:
    Saying(const Language& language, NameDetail detail, bool is_all_capitals)
        : language_(language), detail_(detail), is_all_capitals_(is_all_capitals) {}

    std::vector<Said> all(std::span<const NamePart> parts) {
        const bool is_whole = detail_ == NameDetail::whole;
        if (parts.size() > 1 && !is_whole && is_camera(parts[0], parts[1]))
            parts = after_photo(parts.subspan(1));
        while (!parts.empty()) parts = parts.subspan(say_first(parts));
        return std::move(said_);
    }

  private:
    std::string words(const NameMoment& moment) const {
        const bool is_precise = detail_ == NameDetail::precise || detail_ == NameDetail::whole;
        return words_of(moment, language_, is_precise);
    }

    [[nodiscard]] bool is_spelled(std::string_view word) const {
        if (is_without_vowel(word)) return true;
        const bool means_something = !is_all_capitals_ || is_camera_mark(word);
        return means_something && is_short_in_capitals(word);
    }

    /// Says "photo of 5th April 2023" or "photo 45 12", and returns the other parts.
    std::span<const NamePart> after_photo(std::span<const NamePart> parts) {
        if (const auto moment = moment_of(parts)) {
            const std::string taken = words(*moment);
            said_.push_back({language_.text("file", "photo of {0}", {taken}), true, true, false});
            return parts.subspan(moment->parts);
        }
        const std::string number = in_groups(without_zeros(parts[0].text));
        said_.push_back({language_.text("file", "photo {0}", {number}), false, true, false});
        return parts.subspan(1);
    }

    /// Returns how many parts it said.
    std::size_t say_first(std::span<const NamePart> parts) {
        const NamePart& part = parts.front();
        const Said* const before = said_.empty() ? nullptr : &said_.back();
        if (const auto moment = moment_of(parts)) {
            said_.push_back({words(*moment), true, true, false});
            return moment->parts;
        }
        if (part.is_digits) {
            said_.push_back({said_number(part.text, before), false, true, false});
            return 1;
        }
        const bool is_by_letter = is_spelled(part.text);
        said_.push_back({is_by_letter ? spelled(part.text) : part.text, false, false,
                         is_by_letter && part.text.size() > 1});
        return 1;
    }

    const Language& language_;
    NameDetail detail_;
    bool is_all_capitals_;
    std::vector<Said> said_;
};

std::string joined(const std::vector<Said>& all) {
    std::string text;
    bool is_apart = false;
    bool is_number = false;
    for (const Said& said : all) {
        const bool has_pause = is_apart || said.is_apart || (is_number && said.is_number);
        const std::string next =
            text.empty() ? said.text : text + (has_pause ? ", " : " ") + said.text;
        if (characters_in(next) > spoken_characters && !text.empty()) break;
        text = next;
        is_apart = said.is_apart;
        is_number = said.is_number;
    }
    return text;
}

/// ", J P G"
std::string said_ending(std::string_view name) {
    const auto ending = name.substr(without_ending(name).size());
    return ending.empty() ? "" : ", " + spelled(in_capitals(ending.substr(1)));
}

}  // namespace

std::string spoken_name(std::string_view name, const Language& language, const NameForm& form) {
    const bool has_ending =
        form.detail == NameDetail::with_ending || form.detail == NameDetail::whole;
    const std::string ending = has_ending ? said_ending(name) : "";
    const auto parts = parts_of_name(without_ending(name), spoken_characters);
    std::string text =
        joined(Saying(language, form.detail, is_all_capitals(name, parts)).all(parts));
    if (text.empty()) text = language.text("visit", "a file without a name");
    text += ending;
    if (form.number == 0) return text;
    return language.text("file", "{0}, number {1}", {text, std::to_string(form.number)});
}

}  // namespace touchline
