// Words for the parts of a map and for the whole map.
// Threads: pure functions.
#pragma once

#include "config/types/tactile_map.h"
#include "vision/simplify/simplify.h"

#include <string>
#include <string_view>

namespace touchline {

/// Returns where the middle of an outline's extent lies, in thirds of the area: "upper left",
/// "top", "upper right", "left", "middle", "right", "lower left", "bottom", "lower right".
/// O(points).
[[nodiscard]] std::string_view place_of(const Outline& outline, const Area& area);

/// Labels all outlines by kind and place: "closed line, upper left"; the second of a kind and place
/// is "closed line 2, upper left". `of`: what each one shows.
void label_by_place(TactileMap& map, const std::vector<LineOf>& of);

/// Returns how hard the map is to take in, by the strokes and the length of line that a detail
/// allows.
[[nodiscard]] Complexity complexity_of(int parts, double line_mm, const Area& area);

/// Returns sentences of at most 15 words: how many parts, how long, how hard, where the largest is,
/// and what helps if lines were left out.
[[nodiscard]] std::string words_for(const TactileMap& map, const SimplifyReport& report,
                                    int detail);

}  // namespace touchline
