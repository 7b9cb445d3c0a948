// Which outlines matter, and at which detail each is first shown.
// Threads: pure functions, O(n log n).
#pragma once

#include "vision/contour/chain.h"

#include <array>

namespace touchline {

/// What a hand can take in at one detail. Tracing at 30-60 mm/s, a metre is half a minute.
struct DetailBudget {
    int outlines = 0;
    double line_m = 0.0;
};

/// Detail 1 ... 5. Guidance for touch: a silhouette is one or two strokes of at most 0.6 m, the
/// main parts five strokes and a metre. The last row bounds what a picture can ask of the haptics
/// at all (a field of noise has tens of thousands of lines): 8 m at 0.2 mm spacing is 40 000
/// points.
inline constexpr std::array<DetailBudget, 5> kDetailBudgets{
    {{2, 0.6}, {6, 1.0}, {20, 2.0}, {60, 4.0}, {400, 8.0}}};

struct RankedOutline {
    Chain chain;
    double salience = 0.0;  // 0..1
    int detail = 0;         // 1..5; 6: beyond every budget
};

/// Salience = contrast x extent (x 1.5 if closed, then scaled to at most 1): contrast r / (1 + r)
/// with r = mean strength / high, extent 1 - exp(-length / 40 mm). Sorted by falling salience (ties
/// keep their order); the detail is the lowest whose budget holds the outline and all before it.
/// The first is always detail 1.
[[nodiscard]] std::vector<RankedOutline> ranked(std::vector<Chain> chains, double high,
                                                double metres_per_px);

}  // namespace touchline
