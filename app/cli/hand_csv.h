// The tables of `touchline feel`: the hand's path, in a table as programs write it (RFC 4180), and
// the words of RUN.csv. Threads: values and pure functions.
#pragma once

#include "config/types/hand_state.h"
#include "config/types/result.h"
#include "config/types/vec2.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

struct CsvRow {
    std::size_t line = 1;             // where it begins in the text
    std::vector<std::string> fields;  // without quotes; unquoted ones without blanks around
};

struct CsvTable {
    char separator = ',';      // the first row's
    std::vector<CsvRow> rows;  // those that are not blank
};

/// The separator is the one outside of quotes in the first row, or a comma if it has none; a line
/// "sep=;" before it sets it too. Fails with one line that names the text's line: UTF-16, a NUL, an
/// unclosed quote, letters after a closing quote. O(text).
[[nodiscard]] Result<CsvTable> csv_table(std::string_view text);

struct HandRow {
    double t_s = 0.0;
    Position p_WH;
    double angle_rad = 0.0;  // of a held shape
};

/// The required columns.
enum class HandColumns : std::uint8_t {
    place,            // t_s,x_m,y_m
    place_and_angle,  // t_s,x_m,y_m,angle_rad
};

/// Reads a table with any separator (csv_table()) whose first line names the columns, in any order.
/// The required ones must occur once; others are ignored. A number has a decimal point, or a comma
/// if commas do not separate the values. Times increase strictly, numbers are finite, |x| and |y|
/// are at most 1 m, |angle| at most 1000 rad, and there is at least one row. The error names the
/// line.
[[nodiscard]] Result<std::vector<HandRow>> parse_hand_csv(std::string_view text,
                                                          HandColumns wanted = HandColumns::place);

[[nodiscard]] constexpr std::string_view name_of(ContactState state) {
    constexpr std::array<std::string_view, 3> names{"free", "edge", "vertex"};
    return names[static_cast<std::size_t>(state)];
}

[[nodiscard]] constexpr std::string_view name_of(ForceState state) {
    constexpr std::array<std::string_view, force_state_count> names{"off", "armed", "ramp", "live",
                                                                    "fault"};
    return names[static_cast<std::size_t>(state)];
}

[[nodiscard]] constexpr std::string_view name_of(Fault fault) {
    constexpr std::array<std::string_view, fault_count> names{
        "none",      "device_lost",   "too_fast",   "energy",        "ringing",
        "knob_lost", "position_jump", "not_finite", "emergency_stop"};
    return names[static_cast<std::size_t>(fault)];
}

[[nodiscard]] constexpr std::string_view name_of(Limit limit) {
    constexpr std::array<std::string_view, limit_count> names{
        "none",   "gain", "slew",  "torque", "force",       "heat",
        "damped", "pose", "speed", "hand",   "unreachable", "fault"};
    return names[static_cast<std::size_t>(limit)];
}

}  // namespace touchline
