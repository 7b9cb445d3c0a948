#include "config/settings/setting_texts.h"

#include <algorithm>

namespace touchline {
namespace {

bool is_control(char letter) {
    constexpr unsigned char blank = 0x20;
    constexpr unsigned char rubout = 0x7f;
    const auto code = static_cast<unsigned char>(letter);
    return code < blank || code == rubout;
}

bool is_line(const std::string& text, std::size_t longest) {
    return text.size() <= longest && std::none_of(text.begin(), text.end(), is_control);
}

/// Empty, or a path from the root, so that nothing depends on where the program was started.
bool is_path(const std::string& text) {
    constexpr std::size_t longest = 4000;
    return text.empty() || (text.front() == '/' && is_line(text, longest));
}

bool is_device(const std::string& text) {
    constexpr std::string_view folder = "/dev/input/";
    return text.empty() || (text.starts_with(folder) && text.size() > folder.size() &&
                            text.find("..") == std::string::npos && is_path(text));
}

/// Converts "09:05" to minutes; 24:00 is the end of the day.
std::optional<int> minute_in(std::string_view text) {
    const auto digit = [&](std::size_t at) { return text[at] - '0'; };
    const auto is_digit = [&](std::size_t at) { return text[at] >= '0' && text[at] <= '9'; };
    if (text.size() != 5 || text[2] != ':' || !is_digit(0) || !is_digit(1) || !is_digit(3) ||
        !is_digit(4))
        return std::nullopt;
    const int minutes = digit(3) * 10 + digit(4);
    const int minute = (digit(0) * 10 + digit(1)) * 60 + minutes;
    if (minutes > 59 || minute > minutes_a_day) return std::nullopt;
    return minute;
}

bool is_code(std::string_view text) {
    return (text.size() == 2 || text.size() == 3) &&
           std::all_of(text.begin(), text.end(),
                       [](char letter) { return letter >= 'a' && letter <= 'z'; });
}

bool is_name(std::string_view text) {
    constexpr std::size_t longest = 40;
    return text.size() <= longest && std::all_of(text.begin(), text.end(), [](char letter) {
               return (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9') ||
                      letter == '-';
           });
}

}  // namespace

std::optional<HoursOfDay> hours_in(std::string_view text) {
    constexpr std::size_t dash = 5;
    if (text.size() != 2 * dash + 1 || text[dash] != '-') return std::nullopt;
    const auto begin = minute_in(text.substr(0, dash));
    const auto end = minute_in(text.substr(dash + 1));
    if (!begin || !end || *begin == minutes_a_day || *end == 0 || *begin == *end)
        return std::nullopt;
    return HoursOfDay{*begin, *end};
}

std::string hours_text(const HoursOfDay& hours) {
    const auto clock = [](int minute) {
        const auto two = [](int number) {
            return (number < 10 ? "0" : "") + std::to_string(number);
        };
        return two(minute / 60) + ':' + two(minute % 60);
    };
    return clock(hours.begin_min) + '-' + clock(hours.end_min);
}

bool is_within(const HoursOfDay& hours, int minute) {
    const bool has_begun = minute >= hours.begin_min;
    const bool has_not_ended = minute < hours.end_min;
    return hours.begin_min < hours.end_min ? has_begun && has_not_ended
                                           : has_begun || has_not_ended;
}

std::optional<std::vector<std::string>> languages_in_text(std::string_view text) {
    constexpr std::size_t most = 16;
    std::vector<std::string> codes;
    while (true) {
        const std::size_t end = std::min(text.find(' '), text.size());
        const std::string code(text.substr(0, end));
        const bool is_known = std::find(codes.begin(), codes.end(), code) != codes.end();
        if (!is_code(code) || is_known || codes.size() == most) return std::nullopt;
        codes.push_back(code);
        if (end == text.size()) return codes;
        text.remove_prefix(end + 1);
    }
}

bool is_allowed(TextKind kind, const std::string& text) {
    constexpr std::size_t longest_notice = 200;
    switch (kind) {
        case TextKind::path:
            return is_path(text);
        case TextKind::device:
            return is_device(text);
        case TextKind::hours:
            return hours_in(text).has_value();
        case TextKind::quiet:
            return text.empty() || hours_in(text).has_value();
        case TextKind::languages:
            return languages_in_text(text).has_value();
        case TextKind::language:
            return is_code(text);
        case TextKind::notice:
            return is_line(text, longest_notice);
        case TextKind::name:
            return is_name(text);
    }
    return false;
}

std::string_view allowed_texts(TextKind kind) {
    switch (kind) {
        case TextKind::path:
            return "a path that begins with /, or \"\" for none";
        case TextKind::device:
            return "a path that begins with /dev/input/, or \"\" for none";
        case TextKind::hours:
            return "two times like \"09:00-17:00\"";
        case TextKind::quiet:
            return "two times like \"18:00-22:00\", or \"\" for none";
        case TextKind::languages:
            return "codes of languages like \"en de fr\"";
        case TextKind::language:
            return "the code of a language like \"en\"";
        case TextKind::notice:
            return "a line of at most 200 bytes, or \"\" for none";
        case TextKind::name:
            return "a name of small letters, digits and \"-\", or \"\" for none";
    }
    return {};
}

}  // namespace touchline
