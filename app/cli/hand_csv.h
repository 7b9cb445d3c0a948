// The hand's path as a table, for `touchline feel`.
// Threads: pure functions.
#pragma once

#include "config/types/result.h"
#include "config/types/vec2.h"

#include <string_view>
#include <vector>

namespace touchline {

struct HandRow {
    double t_s = 0.0;
    Position p_WH;
};

/// Comma-separated, its first line naming the columns; t_s, x_m and y_m must be there, others are
/// ignored. Times increase strictly, numbers are finite, |x| and |y| at most 1 m, at least one row.
/// The error names the line.
[[nodiscard]] Result<std::vector<HandRow>> parse_hand_csv(std::string_view text);

}  // namespace touchline
