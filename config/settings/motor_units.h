// How the motors of a unit stand to its joints, where each motor has a controller of its own: what
// the site measured once and a file keeps, by the make of the controllers.
// Threads: values and pure functions.
#pragma once

#include "config/types/result.h"

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// One motor: the controller's id on its bus, the way the joint turns while the reported turns
/// rise, turns of the shaft for one of the joint, and what is reported at home.
struct MotorSettings {
    int id = 1;  // 1 to 126
    bool is_clockwise = false;
    double ratio = 1.0;       // 0.01 to 100
    double zero_turns = 0.0;  // -1000 to 1000

    friend bool operator==(const MotorSettings&, const MotorSettings&) = default;
};

struct MotorUnit {
    std::string make;                       // as the setting device.make
    std::array<MotorSettings, 2> motors{};  // of joint 1, of joint 2; ids differ

    friend bool operator==(const MotorUnit&, const MotorUnit&) = default;
};

/// Parses the text of a file; `name` is the file's, for the error. Malformed text, an unknown key
/// or a value out of range gives a one-line error with file and line number.
[[nodiscard]] Result<std::vector<MotorUnit>> parse_motor_units(std::string_view text,
                                                               std::string_view name);

/// Reads at most 1 MB. No file is no unit.
[[nodiscard]] Result<std::vector<MotorUnit>> read_motor_units(const std::filesystem::path& file);

/// Returns text that parse_motor_units() reads back to the same units.
[[nodiscard]] std::string motor_units_text(const std::vector<MotorUnit>& units);

}  // namespace touchline
