// Finds when a moving wall meets a point at rest: a change of level moves every segment of the
// curves, each end straight and evenly. Threads: pure functions, no allocation.
#pragma once

#include "config/types/vec2.h"
#include "haptics/curve/curve_set.h"

#include <optional>

namespace touchline {

/// A change of the rendered level between finer + from and finer + to; weights 0 ... 1 in either
/// order. Segments are named as those of level `finer`, even if a weight is 1.
struct LevelChange {
    int finer = 0;
    double from = 0.0;
    double to = 0.0;
};

/// The first segment that reaches a place.
struct WallHit {
    bool is_hit = false;
    bool is_complete = true;  // false: the budget ended first, and nothing is known
    double share = 1.0;       // of the change
    SegmentRef segment;
    double parameter = 0.0;  // of the point that reaches it, on the segment
    bool was_left = false;   // the place lay to the left of the segment
    int boxes = 0;           // opened
};

struct WallMeeting {
    double share = 0.0;
    double parameter = 0.0;
    bool was_left = false;
};

/// Returns the first moment at which a segment whose ends move straight and evenly passes over p,
/// its ends extended by a quarter of the contact skin. Returns nothing if it only comes near.
[[nodiscard]] std::optional<WallMeeting> meeting(Position p, const Segment& from,
                                                 const Segment& to);

}  // namespace touchline
