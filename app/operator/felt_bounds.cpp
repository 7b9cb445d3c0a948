#include "app/operator/felt_bounds.h"

#include "app/operator/setting_words.h"

#include <cmath>

namespace touchline {
namespace {

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
