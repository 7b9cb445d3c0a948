#include "config/settings/setting_rows.h"

#include "config/settings/setting_texts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace touchline {
namespace {

std::string short_number(double value) {
    std::array<char, 32> text{};
    (void)std::snprintf(text.data(), text.size(), "%.6g", value);
    return text.data();
}

bool is_in(const SettingRange& range, double value) {
    return value >= range.least && value <= range.most;
}

struct Put {
    Settings& settings;
    const SettingRow& row;
    const SettingValue& value;

    bool operator()(bool Settings::*field) const { return assign<bool>(field, true); }

    bool operator()(double Settings::*field) const {
        const double* number = std::get_if<double>(&value);
        return assign<double>(field, number != nullptr && is_in(row.range, *number));
    }

    bool operator()(std::string Settings::*field) const {
        const std::string* text = std::get_if<std::string>(&value);
        return assign<std::string>(field, text != nullptr && is_allowed(row.text, *text));
    }

    template <class T>
    bool assign(T Settings::*field, bool is_allowed) const {
        const T* given = std::get_if<T>(&value);
        if (given == nullptr || !is_allowed) return false;
        settings.*field = *given;
        return true;
    }

    bool operator()(int Settings::*field) const {
        const double* number = std::get_if<double>(&value);
        if (number == nullptr || !is_in(row.range, *number) || std::floor(*number) != *number)
            return false;
        settings.*field = static_cast<int>(*number);
        return true;
    }

    template <class Choice>
    bool operator()(Choice Settings::*field) const {
        const std::string* name = std::get_if<std::string>(&value);
        if (name == nullptr) return false;
        const auto found = std::find(row.choices.begin(), row.choices.end(), *name);
        if (found == row.choices.end()) return false;
        settings.*field = static_cast<Choice>(found - row.choices.begin());
        return true;
    }
};

/// Steps on the grid that starts at the least value, so that sums of tenths stay tenths.
double next_on_grid(const SettingRange& range, double value, bool is_up) {
    const double steps = (value - range.least) / range.step + (is_up ? 1.0 : -1.0);
    const double whole = is_up ? std::floor(steps + 1e-9) : std::ceil(steps - 1e-9);
    return std::clamp(range.least + whole * range.step, range.least, range.most);
}

}  // namespace

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
    if (!std::visit(Put{settings, row, value}, row.field)) return std::nullopt;
    return settings;
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

std::string settings_as_markdown() {
    constexpr std::array<std::string_view, 4> layers{"program", "site", "profile", "session"};
    const Settings defaults;
    std::string text =
        "| setting | allowed | at first | up to | what it does |\n|---|---|---|---|---|\n";
    for (const SettingRow& row : setting_rows()) {
        text += "| `" + std::string(row.table) + '.' + std::string(row.key) + "` | " +
                allowed_values(row) + " | " + value_in_words(defaults, row) + " | " +
                std::string(layers[static_cast<std::size_t>(row.last_layer)]) + " | " +
                std::string(row.name) + ": " + std::string(row.help) + " |\n";
    }
    return text;
}

}  // namespace touchline
