// A leader: the straight thin line from a label to what it names, broken at lines on its way.
// Threads: pure functions.
#pragma once

#include "app/sheets/stroke_grid.h"
#include "app/sheets/tactile_sheet.h"

#include <optional>
#include <vector>

namespace touchline {

inline constexpr double leader_half_mm = thin_line_mm / 2.0;
inline constexpr double least_start_mm = 5.0;  // of the piece that begins at the line

struct LeaderWay {
    std::vector<SheetStroke> pieces;
    int breaks = 0;
    double near_mm = 0.0;  // how much of it is less than twice least_clear_mm from a line
};

/// From `anchor` to `port`; `grid` holds the lines, and its reach is beyond twice least_clear_mm.
/// Nothing if it leaves its line or crosses one at too flat an angle, for then a gap is longer than
/// a fingertip, or if too little of it would be left. O(length * segments nearby).
[[nodiscard]] std::optional<LeaderWay> leader_way(PaperPoint anchor, PaperPoint port,
                                                  const StrokeGrid& grid);

}  // namespace touchline
