// Ranks lines by how much they matter. Chains here are in millimetres.
// Threads: pure function, O(n log n).
#pragma once

#include "vision/contour/chain.h"

#include <vector>

namespace touchline {

struct RankedLine {
    Chain line;
    double salience = 0.0;     // 0..1
    double outer_share = 0.0;  // 0..1, see surroundings.h
};

/// Salience = length x contrast x closure x place: length 1 - exp(-length / 150 mm); contrast r /
/// (1 + r), r = mean strength / high, never zero; closure 1 for a closed line, 2/3 for an open one
/// (a finger can lose it); place 1 outside ... 0.7 inside; never less than the least weight of a
/// map's outline. Sorted by falling salience; ties keep their order. `outer_shares`: one for each
/// line.
[[nodiscard]] std::vector<RankedLine> ranked(std::vector<Chain> lines,
                                             const std::vector<double>& outer_shares, double high);

}  // namespace touchline
