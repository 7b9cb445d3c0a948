// Lines that a finger can tell apart: where two come too near, the less important one is broken.
// Threads: pure functions.
#pragma once

#include "app/sheets/tactile_sheet.h"
#include "config/types/tactile_map.h"

#include <functional>
#include <vector>

namespace touchline {

/// From the picture frame W to the page.
struct PaperPlace {
    PaperPoint middle;   // where the origin of W lies
    double scale = 1.0;  // millimetres on paper per millimetre of the map

    [[nodiscard]] PaperPoint operator()(Position p_W) const {
        return {middle.x_mm + 1000.0 * scale * p_W.x, middle.y_mm - 1000.0 * scale * p_W.y};
    }
};

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

/// The more important of two is the one of lower detail, then of more weight, then the longer. The
/// other is broken where they cross, is left out where they run beside each other or along the same
/// way, and is kept where one ends on the other or both have one label. No two strokes are nearer
/// than `clear_mm`, but within joint_reach_mm of where they meet. Breaks at crossings are not told
/// as left out. What an outline does to itself stays. O(points).
[[nodiscard]] PaperLines paper_lines(const TactileMap& map, const PaperPlace& place, PaperSize page,
                                     const GapRule& rule = {});

}  // namespace touchline
