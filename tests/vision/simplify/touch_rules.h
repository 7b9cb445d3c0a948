// Judges a map to be felt by its rules, by brute force: whole nanometres, every pair of places,
// none of the code under test but the map. Lengths in millimetres.
#pragma once

#include "config/types/tactile_map.h"

#include <string>
#include <vector>

namespace touchline::testing {

/// The table that the rules follow, for an area with a diagonal of 215 mm.
struct TouchRules {
    int strokes;
    double line_mm;
    double stroke_mm;
    double gap_mm;
    double bridge_mm = 0.0;  // how much farther than a gap from a foot spacing does not count
};

/// Returns the rules for detail 1 ... 5, with counts and lengths scaled to the area.
[[nodiscard]] TouchRules touch_rules(int detail, const Area& area);

/// Returns what is wrong with a map, one text per fault; empty if nothing is. The rules:
/// * strokes, length of line, length of each stroke;
/// * spacing: places 0.3 mm apart on two outlines, or more than four gaps apart along one, are a
///   gap apart, except within a gap (and `bridge_mm`) of a place where one outline ends on another,
///   of an end that a crossing left open (2.5 mm from the other line) or of a corner (turn of 40
///   degrees over 1 mm); two rings, neither within the other, are 3.2 mm apart;
/// * no two segments cross.
[[nodiscard]] std::vector<std::string> faults_of(const TactileMap& map, const TouchRules& rules);

/// Returns the share of a line's places, 0.3 mm apart, that lie within `reach_mm` of the map.
[[nodiscard]] double covered_share(const std::vector<Position>& ring, const TactileMap& map,
                                   double reach_mm);

/// Returns millimetres.
[[nodiscard]] double length_of(const Outline& outline);

}  // namespace touchline::testing
