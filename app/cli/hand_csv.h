// The hand's path as a table, for `touchline feel`.
// Threads: pure functions.
#pragma once

#include "config/types/result.h"
#include "config/types/vec2.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace touchline {

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

/// Reads a table with any separator (csv_table.h) whose first line names the columns, in any order.
/// The required ones must occur once; others are ignored. A number has a decimal point, or a comma
/// if commas do not separate the values. Times increase strictly, numbers are finite, |x| and |y|
/// are at most 1 m, |angle| at most 1000 rad, and there is at least one row. The error names the
/// line.
[[nodiscard]] Result<std::vector<HandRow>> parse_hand_csv(std::string_view text,
                                                          HandColumns wanted = HandColumns::place);

}  // namespace touchline
