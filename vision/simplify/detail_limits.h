// What a hand can take in at each detail, in millimetres at the handle.
// Source: guidance for raised-line pictures and one moving point; starting values, to be tuned with
// people. Threads: pure functions, O(1).
#pragma once

#include "config/types/tactile_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace touchline {

inline constexpr int most_detail = 5;

/// What may be shown inside an outer line.
enum class InnerLines { none, large_regions, all };

/// Lengths in millimetres. Traced at 30 to 60 mm/s, a metre takes half a minute.
struct DetailLimits {
    int strokes = 0;                // outlines, at most
    double line_mm = 0.0;           // of all outlines together, at most
    double least_stroke_mm = 0.0;   // of one outline
    double gap_mm = 0.0;            // between two lines
    double tolerance_mm = 0.0;      // wiggles of this size are smoothed away
    double least_feature_mm = 0.0;  // corners that turn within less than this are rounded off
    InnerLines inner = InnerLines::all;
};

/// Returns the limits of detail 1 (silhouette) ... 5 (all). Counts and lengths of line grow with
/// the area's diagonal (the table is made for 215 mm); counts are rounded down and never below two.
/// Gap, tolerance and feature belong to the hand and stay the same.
[[nodiscard]] inline DetailLimits limits_for(int detail, const Area& area) {
    constexpr double table_diagonal_m = 0.215;
    constexpr int least_strokes = 2;  // of two things side by side, neither may be lost
    constexpr std::array<DetailLimits, most_detail> table{{
        {2, 600.0, 60.0, 12.0, 2.0, 12.0, InnerLines::none},
        {5, 1000.0, 40.0, 8.0, 1.5, 10.0, InnerLines::large_regions},
        {9, 1500.0, 25.0, 6.0, 1.0, 8.0, InnerLines::all},
        {16, 2500.0, 15.0, 5.0, 0.7, 6.0, InnerLines::all},
        {40, 5000.0, 10.0, 3.2, 0.5, 4.0, InnerLines::all},
    }};
    DetailLimits limits = table[static_cast<std::size_t>(std::clamp(detail, 1, most_detail)) - 1];
    const double scale = std::hypot(area.width_m, area.height_m) / table_diagonal_m;
    limits.strokes = std::max(least_strokes, static_cast<int>(limits.strokes * scale));
    limits.line_mm *= scale;
    limits.least_stroke_mm *= scale;
    return limits;
}

}  // namespace touchline
