#include "config/settings/setting_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace touchline {
namespace {

constexpr std::array<std::string_view, 4> modes{"wall", "groove", "ridge", "stay"};

constexpr std::array rows{
    SettingRow{"feel",
               "mode",
               &Settings::mode,
               {},
               modes,
               "Kind of line",
               "",
               "How a line feels: a wall, a groove, a ridge, or a groove that holds on."},
    SettingRow{"feel",
               "stiffness_N_per_m",
               &Settings::stiffness_N_per_m,
               {100.0, 700.0, 50.0},
               {},
               "Stiffness",
               "newtons per metre",
               "How firm lines are."},
    SettingRow{"feel",
               "friction",
               &Settings::friction,
               {0.0, 1.0, 0.1},
               {},
               "Friction",
               "",
               "How much the handle is held back along a line."},
    SettingRow{"feel",
               "capture_mm",
               &Settings::capture_mm,
               {1.0, 10.0, 0.5},
               {},
               "Reach of a groove",
               "millimetres",
               "How far from a line it begins to pull."},
    SettingRow{"feel",
               "gives_way",
               &Settings::gives_way,
               {},
               {},
               "Walls give way",
               "",
               "A long push leads through a wall."},
    SettingRow{"feel",
               "give_way_N",
               &Settings::give_way_N,
               {0.5, 3.0, 0.1},
               {},
               "Push that leads through",
               "newtons",
               "How hard that push has to be.",
               SettingLayer::profile},
    SettingRow{"levels",
               "automatic",
               &Settings::is_level_automatic,
               {},
               {},
               "Level follows the hand",
               "",
               "The faster the hand, the coarser the line."},
    SettingRow{"levels",
               "fixed",
               &Settings::fixed_level,
               {0.0, 16.0, 1.0},
               {},
               "Fixed level",
               "",
               "The level where it does not follow the hand; 0 is the finest."},
    SettingRow{"levels",
               "finest",
               &Settings::finest_level,
               {0.0, 16.0, 1.0},
               {},
               "Finest level",
               "",
               "A level that follows the hand gets no finer.",
               SettingLayer::profile},
    SettingRow{"levels",
               "coarsest",
               &Settings::coarsest_level,
               {0.0, 16.0, 1.0},
               {},
               "Coarsest level",
               "",
               "A level that follows the hand gets no coarser.",
               SettingLayer::profile},
    SettingRow{"picture",
               "detail",
               &Settings::detail,
               {1.0, 5.0, 1.0},
               {},
               "Detail",
               "",
               "1 is the silhouette alone, 5 is all there is."},
    SettingRow{"screen",
               "viewing_distance_m",
               &Settings::viewing_distance_m,
               {0.3, 3.0, 0.1},
               {},
               "Distance of the eyes",
               "metres",
               "Letters are as large as it needs.",
               SettingLayer::site},
    SettingRow{"stick",
               "watched_folder",
               &Settings::watched_folder,
               {},
               {},
               "Folder in place of a stick",
               "",
               "For a machine without udisks2: a path; empty means USB sticks.",
               SettingLayer::site},
};

// The names are in the order of the enumeration.
static_assert(static_cast<int>(Mode::wall) == 0 && static_cast<int>(Mode::stay) == 3);

std::string short_number(double value) {
    std::array<char, 32> text{};
    (void)std::snprintf(text.data(), text.size(), "%.6g", value);
    return text.data();
}

bool is_in(const SettingRange& range, double value) {
    return value >= range.least && value <= range.most;
}

bool is_control(char letter) {
    constexpr unsigned char blank = 0x20;
    constexpr unsigned char rubout = 0x7f;
    const auto code = static_cast<unsigned char>(letter);
    return code < blank || code == rubout;
}

/// Empty, or a path from the root: nothing depends on where the program was started.
bool is_path(const std::string& text) {
    constexpr std::size_t longest = 4000;
    return text.empty() || (text.front() == '/' && text.size() <= longest &&
                            std::none_of(text.begin(), text.end(), is_control));
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
        return assign<std::string>(field, text != nullptr && is_path(*text));
    }

    bool operator()(int Settings::*field) const {
        return row.choices.empty() ? put_whole(field) : put_choice(field);
    }

    template <class T>
    bool assign(T Settings::*field, bool is_allowed) const {
        const T* given = std::get_if<T>(&value);
        if (given == nullptr || !is_allowed) return false;
        settings.*field = *given;
        return true;
    }

    bool put_whole(int Settings::*field) const {
        const double* number = std::get_if<double>(&value);
        if (number == nullptr || !is_in(row.range, *number) || std::floor(*number) != *number)
            return false;
        settings.*field = static_cast<int>(*number);
        return true;
    }

    bool put_choice(int Settings::*field) const {
        const std::string* name = std::get_if<std::string>(&value);
        if (name == nullptr) return false;
        const auto found = std::find(row.choices.begin(), row.choices.end(), *name);
        if (found == row.choices.end()) return false;
        settings.*field = static_cast<int>(found - row.choices.begin());
        return true;
    }
};

/// On the grid of steps from the least on, so that sums of tenths stay tenths.
double next_on_grid(const SettingRange& range, double value, bool is_up) {
    const double steps = (value - range.least) / range.step + (is_up ? 1.0 : -1.0);
    const double whole = is_up ? std::floor(steps + 1e-9) : std::ceil(steps - 1e-9);
    return std::clamp(range.least + whole * range.step, range.least, range.most);
}

}  // namespace

std::span<const SettingRow> setting_rows() {
    return rows;
}

const SettingRow* find_setting(std::string_view table, std::string_view key) {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const SettingRow& row) {
        return row.table == table && row.key == key;
    });
    return found == rows.end() ? nullptr : &*found;
}

std::string allowed_values(const SettingRow& row) {
    if (std::holds_alternative<bool Settings::*>(row.field)) return "true or false";
    if (std::holds_alternative<std::string Settings::*>(row.field))
        return "a path that begins with /, or \"\" for none";
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

std::string contradiction(const Settings& settings) {
    if (settings.finest_level > settings.coarsest_level)
        return "'levels.finest' must not be above 'levels.coarsest'";
    return {};
}

SettingValue value_of(const Settings& settings, const SettingRow& row) {
    return std::visit(
        [&](auto field) -> SettingValue {
            using T = std::remove_cvref_t<decltype(settings.*field)>;
            if constexpr (std::is_same_v<T, int>) {
                if (row.choices.empty()) return static_cast<double>(settings.*field);
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
    for (const SettingRow& row : rows) {
        text += "| `" + std::string(row.table) + '.' + std::string(row.key) + "` | " +
                allowed_values(row) + " | " + value_in_words(defaults, row) + " | " +
                std::string(layers[static_cast<std::size_t>(row.last_layer)]) + " | " +
                std::string(row.name) + ": " + std::string(row.help) + " |\n";
    }
    return text;
}

}  // namespace touchline
