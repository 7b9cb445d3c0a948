// What a hand can take in at each detail, in millimetres at the handle.
// Source: guidance for raised-line pictures and one moving point; starting values, to be tuned with
// people. Threads: pure functions, O(1).
#pragma once

#include "config/types/tactile_map.h"

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
[[nodiscard]] DetailLimits limits_for(int detail, const Area& area);

}  // namespace touchline
