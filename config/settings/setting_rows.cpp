#include "config/settings/setting_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace touchline {
namespace {

bool is_control(char letter) {
    constexpr unsigned char blank = 0x20;
    constexpr unsigned char rubout = 0x7f;
    const auto code = static_cast<unsigned char>(letter);
    return code < blank || code == rubout;
}

bool is_line(std::string_view text, std::size_t longest) {
    return text.size() <= longest && std::none_of(text.begin(), text.end(), is_control);
}

/// Empty, or a path from the root, so that nothing depends on where the program was started.
bool is_path(std::string_view text) {
    constexpr std::size_t longest = 4000;
    return text.empty() || (text.front() == '/' && is_line(text, longest));
}

bool is_device(std::string_view text) {
    constexpr std::string_view folder = "/dev/input/";
    return text.empty() || (text.starts_with(folder) && text.size() > folder.size() &&
                            text.find("..") == std::string_view::npos && is_path(text));
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

/// As CUPS has them.
bool is_queue(std::string_view text) {
    constexpr std::size_t longest = 127;
    return is_line(text, longest) && text.find_first_of(" /#?'\"\\") == std::string_view::npos;
}

/// A file of the system's devices, or a network interface as the kernel names them.
bool is_port(std::string_view text) {
    constexpr std::string_view folder = "/dev/";
    constexpr std::size_t longest_name = 15;
    if (text.find("..") != std::string_view::npos) return false;
    if (text.starts_with(folder)) return text.size() > folder.size() && is_path(text);
    return is_line(text, longest_name) && text.find_first_of(" /:") == std::string_view::npos;
}

bool is_hours(std::string_view text) {
    return hours_in(text).has_value();
}

bool is_quiet(std::string_view text) {
    return text.empty() || is_hours(text);
}

bool are_languages(std::string_view text) {
    return languages_in_text(text).has_value();
}

bool is_notice(std::string_view text) {
    constexpr std::size_t longest = 200;
    return is_line(text, longest);
}

struct TextRule {
    bool (*is_allowed)(std::string_view text);
    std::string_view words;
};

/// In the order of TextKind.
constexpr std::array<TextRule, 10> text_rules{
    {{is_path, "a path that begins with /, or \"\" for none"},
     {is_device, "a path that begins with /dev/input/, or \"\" for none"},
     {is_hours, "two times like \"09:00-17:00\""},
     {is_quiet, "two times like \"18:00-22:00\", or \"\" for none"},
     {are_languages, "codes of languages like \"en de fr\""},
     {is_code, "the code of a language like \"en\""},
     {is_notice, "a line of at most 200 bytes, or \"\" for none"},
     {is_name, "a name of small letters, digits and \"-\", or \"\" for none"},
     {is_queue, "the name of a printer in CUPS, or \"\" for none"},
     {is_port, "a path in /dev/, a CAN interface, NAME@PORT, or \"\" for none"}}};
static_assert(static_cast<std::size_t>(TextKind::port) + 1 == text_rules.size());

std::string short_number(double value) {
    std::array<char, 32> text{};
    (void)std::snprintf(text.data(), text.size(), "%.6g", value);
    return text.data();
}

bool is_in(const SettingRange& range, double value) {
    return value >= range.least && value <= range.most;
}

/// Returns the value as a T if the row allows it.
template <class T>
std::optional<T> allowed(const SettingRow& row, const SettingValue& value) {
    const auto* const number = std::get_if<double>(&value);
    const auto* const text = std::get_if<std::string>(&value);
    if constexpr (std::is_same_v<T, bool>) {
        if (const bool* is_on = std::get_if<bool>(&value)) return *is_on;
    } else if constexpr (std::is_same_v<T, double>) {
        if (number != nullptr && is_in(row.range, *number)) return *number;
    } else if constexpr (std::is_same_v<T, int>) {
        if (number != nullptr && is_in(row.range, *number) && std::floor(*number) == *number)
            return static_cast<int>(*number);
    } else if constexpr (std::is_same_v<T, std::string>) {
        if (text != nullptr && is_allowed(row.text, *text)) return *text;
    } else if (text != nullptr) {
        const auto found = std::find(row.choices.begin(), row.choices.end(), *text);
        if (found != row.choices.end()) return static_cast<T>(found - row.choices.begin());
    }
    return std::nullopt;
}

/// Steps on the grid that starts at the least value, so that sums of tenths stay tenths.
double next_on_grid(const SettingRange& range, double value, bool is_up) {
    const double steps = (value - range.least) / range.step + (is_up ? 1.0 : -1.0);
    const double whole = is_up ? std::floor(steps + 1e-9) : std::ceil(steps - 1e-9);
    return std::clamp(range.least + whole * range.step, range.least, range.most);
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

bool is_allowed(TextKind kind, std::string_view text) {
    return text_rules.at(static_cast<std::size_t>(kind)).is_allowed(text);
}

std::string_view allowed_texts(TextKind kind) {
    return text_rules.at(static_cast<std::size_t>(kind)).words;
}

const SettingRow* find_setting(std::string_view table, std::string_view key) {
    const auto rows = setting_rows();
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const SettingRow& row) {
        return row.table == table && row.key == key;
    });
    return found == rows.end() ? nullptr : &*found;
}

std::string allowed_values(const SettingRow& row) {
    if (std::holds_alternative<bool Settings::*>(row.field)) return "true or false";
    if (std::holds_alternative<std::string Settings::*>(row.field))
        return std::string(allowed_texts(row.text));
    std::string text;
    for (const std::string_view choice : row.choices)
        text += (text.empty() ? "\"" : " or \"") + std::string(choice) + '"';
    if (!text.empty()) return text;
    const bool is_whole = std::holds_alternative<int Settings::*>(row.field);
    return std::string(is_whole ? "a whole number" : "a number") + " from " +
           short_number(row.range.least) + " to " + short_number(row.range.most);
}

std::optional<Settings> with_value(Settings settings, const SettingRow& row,
                                   const SettingValue& value) {
    const auto put = [&]<class T>(T Settings::*field) {
        const auto given = allowed<T>(row, value);
        if (given) settings.*field = *given;
        return given.has_value();
    };
    if (!std::visit(put, row.field)) return std::nullopt;
    return settings;
}

Settings with_settings_of_house(Settings kiosk, const Settings& house) {
    for (const SettingRow& row : setting_rows())
        if (row.owner == SettingOwner::house)
            std::visit([&](auto field) { kiosk.*field = house.*field; }, row.field);
    return kiosk;
}

Settings with_changes(Settings latest, const Settings& base, const Settings& edited) {
    const auto take = [&](auto field) {
        if (edited.*field != base.*field) latest.*field = edited.*field;
    };
    for (const SettingRow& row : setting_rows()) std::visit(take, row.field);
    return latest;
}

std::string trespass(const Settings& before, const Settings& after) {
    if (after.force_ceiling_N > before.force_ceiling_N)
        return "'feel.force_ceiling_N' must not be above the site's " +
               short_number(before.force_ceiling_N);
    return {};
}

std::vector<SettingConflict> conflicts(const Settings& settings) {
    std::vector<SettingConflict> found;
    if (settings.finest_level > settings.coarsest_level)
        found.push_back({"levels.finest", "levels.coarsest",
                         "'levels.finest' must not be above 'levels.coarsest'"});
    const auto codes = languages_in_text(settings.languages);
    if (!codes || std::find(codes->begin(), codes->end(), settings.first_language) == codes->end())
        found.push_back({"language.first", "language.offered",
                         "'language.first' must be one of 'language.offered'"});
    return found;
}

SettingValue value_of(const Settings& settings, const SettingRow& row) {
    return std::visit(
        [&](auto field) -> SettingValue {
            using T = std::remove_cvref_t<decltype(settings.*field)>;
            if constexpr (std::is_same_v<T, int>) {
                return static_cast<double>(settings.*field);
            } else if constexpr (std::is_enum_v<T>) {
                return std::string(row.choices[static_cast<std::size_t>(settings.*field)]);
            } else {
                return settings.*field;
            }
        },
        row.field);
}

Settings stepped(const Settings& settings, const SettingRow& row, bool is_up) {
    const SettingValue now = value_of(settings, row);
    SettingValue next = now;
    if (const bool* is_on = std::get_if<bool>(&now)) next = !*is_on;
    if (const double* number = std::get_if<double>(&now))
        next = next_on_grid(row.range, *number, is_up);
    if (!row.choices.empty()) {
        const auto at =
            std::find(row.choices.begin(), row.choices.end(), std::get<std::string>(now)) -
            row.choices.begin();
        const auto last = static_cast<std::ptrdiff_t>(row.choices.size()) - 1;
        const auto chosen = std::clamp<std::ptrdiff_t>(at + (is_up ? 1 : -1), 0, last);
        next = std::string(row.choices[static_cast<std::size_t>(chosen)]);
    }
    return with_value(settings, row, next).value_or(settings);
}

std::string value_in_words(const Settings& settings, const SettingRow& row) {
    const SettingValue value = value_of(settings, row);
    if (const bool* is_on = std::get_if<bool>(&value)) return *is_on ? "on" : "off";
    if (const std::string* text = std::get_if<std::string>(&value))
        return text->empty() ? "none" : *text;
    const std::string number = short_number(std::get<double>(value));
    return row.unit.empty() ? number : number + ' ' + std::string(row.unit);
}

}  // namespace touchline
