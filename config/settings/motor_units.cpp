#include "config/settings/motor_units.h"

#include "config/settings/settings_text.h"
#include "config/types/choices.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <system_error>

#include <toml++/toml.h>

namespace touchline {
namespace {

constexpr std::array<std::string_view, 4> motor_keys{"id", "clockwise", "ratio", "zero_turns"};

/// Reads tables of motors, and keeps the first fault in `wrong`.
class MotorReader {
  public:
    explicit MotorReader(std::string_view file) : file_(file) {}

    MotorSettings read(const toml::table& table) {
        for (const auto& [key, value] : table)
            if (std::ranges::find(motor_keys, key.str()) == motor_keys.end())
                blame(value, "'" + std::string(key.str()) + "' is not a setting here");
        MotorSettings motor;
        motor.id = static_cast<int>(number(table, "id", 1.0, 126.0));
        motor.ratio = number(table, "ratio", 0.01, 100.0);
        motor.zero_turns = number(table, "zero_turns", -1000.0, 1000.0);
        const auto clockwise = table["clockwise"].value<bool>();
        if (!clockwise) blame(table, "'clockwise' must be true or false");
        motor.is_clockwise = clockwise.value_or(false);
        return motor;
    }

    void blame(const toml::node& node, const std::string& why) {
        if (wrong.empty()) wrong = line_in_file(file_, node.source().begin.line, why);
    }

    std::string wrong;

  private:
    double number(const toml::table& table, std::string_view key, double least, double most) {
        const auto value = table[key].value<double>();
        if (value && *value >= least && *value <= most) return *value;
        blame(table, "'" + std::string(key) + "' must be a number from " + text_of(least) + " to " +
                         text_of(most));
        return least;
    }

    static std::string text_of(double value) {
        std::array<char, 32> digits{};
        const auto end = std::to_chars(digits.begin(), digits.end(), value).ptr;
        return {digits.begin(), end};
    }

    std::string file_;
};

std::string round_trip(double value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.begin(), digits.end(), value).ptr;
    std::string text(digits.begin(), end);
    // Without a point or an exponent it would be read as a whole number.
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

MotorUnit read_unit(MotorReader& reader, std::string make, const toml::node& node) {
    MotorUnit unit{std::move(make), {}};
    if (std::ranges::find(device_makes, unit.make) == device_makes.end())
        reader.blame(node, "'" + unit.make + "' is no make of device");
    const toml::array* const motors = node.as_array();
    const bool is_pair = motors != nullptr && motors->size() == 2 && motors->get(0)->is_table() &&
                         motors->get(1)->is_table();
    if (!is_pair) {
        reader.blame(node, "two motors, one a joint, are needed");
        return unit;
    }
    for (std::size_t i = 0; i < 2; ++i) unit.motors[i] = reader.read(*motors->get(i)->as_table());
    if (unit.motors[0].id == unit.motors[1].id)
        reader.blame(node, "the ids of the motors must differ");
    return unit;
}

Result<std::vector<MotorUnit>> read_motor_tables(const toml::table& tables, std::string_view name) {
    MotorReader reader(name);
    std::vector<MotorUnit> units;
    for (const auto& [make, node] : tables)
        units.push_back(read_unit(reader, std::string(make.str()), node));
    if (!reader.wrong.empty()) return failure(reader.wrong);
    return units;
}

}  // namespace

Result<std::vector<MotorUnit>> parse_motor_units(std::string_view text, std::string_view name) {
    try {
        return read_motor_tables(toml::parse(text), name);
    } catch (const toml::parse_error& error) {
        return failure(
            line_in_file(name, error.source().begin.line, std::string(error.description())));
    }
}

Result<std::vector<MotorUnit>> read_motor_units(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::exists(file, error) && !error) return std::vector<MotorUnit>{};
    return read_settings_file(file).and_then(
        [&](const std::string& text) { return parse_motor_units(text, file.filename().string()); });
}

std::string motor_units_text(const std::vector<MotorUnit>& units) {
    std::string text;
    for (const MotorUnit& unit : units) {
        for (const MotorSettings& motor : unit.motors) {
            text += "[[" + unit.make + "]]\nid = " + std::to_string(motor.id) +
                    "\nclockwise = " + (motor.is_clockwise ? "true" : "false") +
                    "\nratio = " + round_trip(motor.ratio) +
                    "\nzero_turns = " + round_trip(motor.zero_turns) + "\n\n";
        }
    }
    return text;
}

}  // namespace touchline
