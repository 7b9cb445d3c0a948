// Lines that a finger can tell apart: where two come too near, the less important one is broken.
// Threads: pure functions.
#pragma once

#include "app/sheets/paper_place.h"
#include "app/sheets/tactile_sheet.h"
#include "config/types/tactile_map.h"

#include <functional>
#include <vector>

namespace touchline {

struct GapRule {
    double clear_mm = least_clear_mm;  // between edges
    double outer_mm = outer_line_mm;   // width of what is in the silhouette
    double inner_mm = inner_line_mm;   // of the rest
};

/// A line leaves a joint with another within this far along itself; beyond, it runs beside it.
inline constexpr double joint_reach_mm = 14.0;

/// What is left of a map's outlines.
struct PaperLines {
    std::vector<SheetStroke> strokes;   // the most important first
    std::vector<std::size_t> broken;    // outlines that are left out in places for want of room
    std::vector<std::size_t> left_out;  // and those that are left out wholly
};

/// The outlines as they are, in the order of the map; `source` is the place in it.
[[nodiscard]] std::vector<SheetStroke> whole_lines(const TactileMap& map, const PaperPlace& place,
                                                   const GapRule& rule = {});

/// The more important of two is the one of lower detail, then of more weight, then the longer. The
/// other is broken where they cross, is left out where they run beside each other or along the same
/// way, and is kept where one ends on the other or both have one label. No two strokes are nearer
/// than `clear_mm`, but within joint_reach_mm of where these two meet. What is left of a line that
/// goes on along another one ends upon that. Breaks at crossings are not told as left out. What an
/// outline does to itself stays. O(points * strokes near them).
[[nodiscard]] PaperLines paper_lines(const TactileMap& map, const PaperPlace& place, PaperSize page,
                                     const GapRule& rule = {});

}  // namespace touchline
