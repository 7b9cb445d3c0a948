
#include "app/documents/sticks/names.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <array>
#include <utility>

#include <unicode/uchar.h>

namespace touchline {
namespace {

class Parting {
  public:
    void add(const NameCharacter& character, bool is_before_letter) {
        const auto code = character.code;
        if (code < 0 || is_invisible(code)) return part_by(' ');
        if (const auto digit = digit_of(code)) {
            begin_unless(last_ == Last::digits);
            parts_.back().is_digits = true;
            parts_.back().text += static_cast<char>('0' + *digit);
            ++characters_;
            last_ = Last::digits;
        } else if (is_letter(code) || is_number(code)) {
            begin_unless(last_ == Last::word);
            put(character);
            piled_ = 0;
            last_ = Last::word;
        } else if (is_mark(code)) {
            if (last_ == Last::word && ++piled_ <= most_piled_marks) put(character);
        } else if (last_ == Last::word && is_before_letter && is_apostrophe(code)) {
            put(character);
        } else {
            const bool is_plain = character.bytes.size() == 1 && u_isUWhiteSpace(code) == 0;
            part_by(is_plain ? character.bytes[0] : ' ');
        }
    }

    [[nodiscard]] std::size_t characters() const { return characters_; }

    std::vector<NamePart> take() { return std::move(parts_); }

  private:
    enum class Last : unsigned char { gap, word, digits };

    void begin_unless(bool goes_on) {
        if (goes_on) return;
        parts_.push_back({"", std::exchange(gap_, {}), false});
    }

    void put(const NameCharacter& character) {
        parts_.back().text += character.bytes;
        ++characters_;
    }

    void part_by(char gap) {
        gap_ += gap;
        last_ = Last::gap;
    }

    std::vector<NamePart> parts_;
    std::string gap_;
    std::size_t characters_ = 0;
    Last last_ = Last::gap;
    int piled_ = 0;
};

bool is_number_of(const NamePart& part, std::size_t least, std::size_t most) {
    return part.is_digits && part.text.size() >= least && part.text.size() <= most;
}

/// At most nine digits.
int value_of(std::string_view digits) {
    return number_in<int>(digits).value_or(0);
}

bool is_leap(int year) {
    return (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
}

std::optional<NameMoment> day_of(int year, int month, int day, std::size_t parts) {
    constexpr std::array days{31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    if (year < 1900 || year > 2099 || month < 1 || month > 12 || day < 1) return std::nullopt;
    const int last = days[static_cast<std::size_t>(month) - 1] + (month == 2 && is_leap(year));
    if (day > last) return std::nullopt;
    return NameMoment{year, month, day, {}, parts};
}

/// Two numbers before a year: a date only if just one order is possible.
std::optional<NameMoment> day_in_either_order(int first, int second, int year, std::size_t parts) {
    const auto day_first = day_of(year, second, first, parts);
    const auto month_first = day_of(year, first, second, parts);
    if (first != second && day_first && month_first) return std::nullopt;
    return day_first ? day_first : month_first;
}

std::optional<ClockTime> clock_of(int hour, int minute, int second) {
    if (hour > 23 || minute > 59 || second > 59) return std::nullopt;
    return ClockTime{hour, minute, second};
}

/// "20230405", "20230405101500" (also with thousandths), "05042023".
std::optional<NameMoment> moment_in_one(std::string_view digits) {
    constexpr std::size_t date = 8;
    const auto number = [digits](std::size_t at, std::size_t size) {
        return value_of(digits.substr(at, size));
    };
    if (digits.size() == date) {
        if (auto day = day_of(number(0, 4), number(4, 2), number(6, 2), 1)) return day;
        return day_in_either_order(number(0, 2), number(2, 2), number(4, 4), 1);
    }
    const bool has_clock = digits.size() == 12 || digits.size() == 14 || digits.size() == 17;
    if (!has_clock) return std::nullopt;
    auto moment = day_of(number(0, 4), number(4, 2), number(6, 2), 1);
    if (!moment) return std::nullopt;
    moment->clock = clock_of(number(8, 2), number(10, 2), digits.size() > 12 ? number(12, 2) : 0);
    return moment->clock ? moment : std::nullopt;
}

/// "2023-04-05", "05.04.2023": three numbers with the same sign between them.
std::optional<NameMoment> day_in_three(std::span<const NamePart> parts) {
    if (parts.size() < 3 || parts[1].gap.size() != 1 || parts[1].gap != parts[2].gap)
        return std::nullopt;
    const char sign = parts[1].gap[0];
    if (std::string_view("-_. ").find(sign) == std::string_view::npos) return std::nullopt;
    const auto number = [parts](std::size_t at) { return value_of(parts[at].text); };
    if (!is_number_of(parts[1], 1, 2)) return std::nullopt;
    if (is_number_of(parts[0], 4, 4) && is_number_of(parts[2], 1, 2))
        return day_of(number(0), number(1), number(2), 3);
    if (!is_number_of(parts[0], 1, 2) || !is_number_of(parts[2], 4, 4) || sign == ' ')
        return std::nullopt;
    if (sign == '.') return day_of(number(2), number(1), number(0), 3);
    return day_in_either_order(number(0), number(1), number(2), 3);
}

/// True for what programs write between a date and its time, in the languages of the kiosk.
bool is_joining(const NamePart& part) {
    constexpr std::array<std::string_view, 8> words{"at", "um",  "\u00e0", "a\u0300",
                                                    "a",  "las", "alle",   "t"};
    return !part.is_digits && std::ranges::count(words, in_small_letters(part.text)) > 0;
}

struct FoundClock {
    ClockTime clock;
    std::size_t parts = 0;
};

/// "101500", with thousandths too; "10.15.00"; "10-15"; "10h15".
std::optional<FoundClock> digits_of_clock(std::span<const NamePart> parts) {
    if (parts.empty()) return std::nullopt;
    const auto found = [](int hour, int minute, int second,
                          std::size_t count) -> std::optional<FoundClock> {
        const auto clock = clock_of(hour, minute, second);
        if (!clock) return std::nullopt;
        return FoundClock{*clock, count};
    };
    const std::string_view first = parts[0].text;
    if (is_number_of(parts[0], 6, 6) || is_number_of(parts[0], 9, 9))
        return found(value_of(first.substr(0, 2)), value_of(first.substr(2, 2)),
                     value_of(first.substr(4, 2)), 1);
    if (!is_number_of(parts[0], 1, 2)) return std::nullopt;
    const bool has_h = parts.size() > 1 && in_small_letters(parts[1].text) == "h";
    const std::size_t at = has_h ? 2 : 1;
    if (parts.size() <= at || !is_number_of(parts[at], 2, 2)) return std::nullopt;
    const std::string& sign = parts[at].gap;
    const int minute = value_of(parts[at].text);
    const bool goes_on =
        !has_h && parts.size() > at + 1 && parts[at + 1].is_digits && parts[at + 1].gap == sign;
    if (!goes_on) return found(value_of(first), minute, 0, at + 1);
    if (!is_number_of(parts[at + 1], 2, 2)) return std::nullopt;
    return found(value_of(first), minute, value_of(parts[at + 1].text), at + 2);
}

std::optional<FoundClock> clock_in(std::span<const NamePart> parts) {
    constexpr std::size_t most_joining = 2;
    std::size_t joining = 0;
    while (joining < parts.size() && joining < most_joining && is_joining(parts[joining]))
        ++joining;
    auto found = digits_of_clock(parts.subspan(joining));
    if (!found) return std::nullopt;
    found->parts += joining;
    if (found->parts == parts.size()) return found;
    const std::string half = in_small_letters(parts[found->parts].text);
    int& hour = found->clock.hour;
    const bool has_half = (half == "am" || half == "pm") && hour >= 1 && hour <= 12;
    if (!has_half) return found;
    hour = hour % 12 + (half == "pm" ? 12 : 0);
    ++found->parts;
    return found;
}

}  // namespace

std::vector<NamePart> parts_of_name(std::string_view name, std::size_t most_characters) {
    Parting parting;
    while (!name.empty() && parting.characters() < most_characters) {
        const NameCharacter character = first_character(name);
        name.remove_prefix(character.bytes.size());
        parting.add(character, !name.empty() && is_letter(first_character(name).code));
    }
    return parting.take();
}

std::optional<NameMoment> moment_of(std::span<const NamePart> parts) {
    if (parts.empty() || !parts[0].is_digits) return std::nullopt;
    auto moment = moment_in_one(parts[0].text);
    if (!moment) moment = day_in_three(parts);
    if (!moment || moment->clock) return moment;
    const auto clock = clock_in(parts.subspan(moment->parts));
    if (!clock) return moment;
    moment->clock = clock->clock;
    moment->parts += clock->parts;
    return moment;
}

}  // namespace touchline
