#include "app/operator/setting_words.h"

#include <array>
#include <cstdio>

namespace touchline {
namespace {

/// By the language's decimal sign; as many digits as the value has, six at most.
std::string number_in_words(double value, const Language& language) {
    std::array<char, 32> digits{};
    (void)std::snprintf(digits.data(), digits.size(), "%.6g", value);
    std::string text = digits.data();
    const auto point = text.find('.');
    if (point != std::string::npos) text.replace(point, 1, language.text("decimal", "."));
    return text;
}

std::string with_unit(double value, std::string_view unit, const Language& language) {
    const std::string number = number_in_words(value, language);
    if (unit.empty()) return number;
    const bool is_one = number == "1";
    if (is_one && unit.ends_with('s') && unit.find(' ') == std::string_view::npos)
        return language.text("setting", "{0} " + std::string(unit.substr(0, unit.size() - 1)),
                             {number});
    return language.text("setting", "{0} " + std::string(unit), {number});
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

}  // namespace touchline
