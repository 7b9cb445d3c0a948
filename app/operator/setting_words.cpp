#include "app/operator/setting_words.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace touchline {
namespace {

struct Unit {
    const char* one;
    const char* many;  // as a row names it
};

constexpr std::array<Unit, 8> units{{{"{0} newton", "{0} newtons"},
                                     {"{0} newton per metre", "{0} newtons per metre"},
                                     {"{0} millimetre", "{0} millimetres"},
                                     {"{0} metre", "{0} metres"},
                                     {"{0} second", "{0} seconds"},
                                     {"{0} percent", "{0} percent"},
                                     {"{0} inch", "{0} inches"},
                                     {"{0} decibel", "{0} decibels"}}};

/// A row without a unit has its number alone.
std::string with_unit(double value, std::string_view name, const Language& language) {
    const auto unit = std::ranges::find_if(
        units, [name](const Unit& row) { return name == std::string_view(row.many).substr(4); });
    if (unit == units.end()) return language.measured("unit", "{0}", "{0}", value);
    return language.measured("unit", unit->one, unit->many, value);
}

/// Rounds to tens, for the loop's bound is measured and moves a little. Returns nothing if the
/// rounded value is not less.
std::optional<double> less_possible(double set_N_per_m, const StiffnessBound& bound) {
    constexpr double told_N_per_m = 10.0;
    const double possible = possible_N_per_m(bound, set_N_per_m);
    if (!(possible < set_N_per_m)) return std::nullopt;
    const double told = told_N_per_m * std::round(possible / told_N_per_m);
    return told < set_N_per_m ? std::optional(told) : std::nullopt;
}

/// The level felt if it were fixed at this one; nothing if they are the same.
std::optional<double> other_possible(double set_level, LevelTerms terms) {
    terms.finest = terms.coarsest = set_level;
    const double possible = choose_level(terms).level;
    return possible != set_level ? std::optional(possible) : std::nullopt;
}

bool is_level(const SettingRow& row) {
    return row.field == SettingField(&Settings::fixed_level) ||
           row.field == SettingField(&Settings::finest_level) ||
           row.field == SettingField(&Settings::coarsest_level);
}

}  // namespace

std::string setting_name(const SettingRow& row, const Language& language) {
    return language.text("setting", std::string(row.name));
}

std::string setting_help(const SettingRow& row, const Language& language) {
    return language.text("setting", std::string(row.help));
}

std::string setting_value(const Settings& settings, const SettingRow& row,
                          const Language& language) {
    const SettingValue value = value_of(settings, row);
    if (const bool* is_on = std::get_if<bool>(&value))
        return language.text("setting", *is_on ? "on" : "off");
    if (const double* number = std::get_if<double>(&value))
        return with_unit(*number, row.unit, language);
    const std::string& text = std::get<std::string>(value);
    if (!row.choices.empty()) return language.text("setting", text);
    return text.empty() ? language.text("setting", "none") : text;
}

std::string time_in_words(int minute, const Language& language) {
    const std::string minutes = std::to_string(minute % 60);
    return language.text(
        "setting", "{0}:{1}",
        {std::to_string(minute / 60), minutes.size() == 1 ? '0' + minutes : minutes});
}

std::string felt_value(const Settings& settings, const SettingRow& row, const FeltBounds& bounds,
                       const Language& language) {
    const std::string value = setting_value(settings, row, language);
    const auto told = [&](const char* text, const std::optional<double>& possible) {
        if (!possible) return value;
        return language.text("operator", text, {value, language.number(*possible, 0)});
    };
    if (row.field == SettingField(&Settings::stiffness_N_per_m))
        return told("{0} set, {1} possible on this loop",
                    less_possible(settings.stiffness_N_per_m, bounds.stiffness));
    if (!is_level(row) || !bounds.levels) return value;
    const double level = std::get<double>(value_of(settings, row));
    return told("{0} set, {1} possible in this picture", other_possible(level, *bounds.levels));
}

}  // namespace touchline
