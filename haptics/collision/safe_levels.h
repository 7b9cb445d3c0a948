// Finds which levels of a piece are safe: on the way from one level to the next, no line passes
// over a line that is not its neighbour. Else a hand between the two would be
// on the other side of one. Done once, when a map is built. Threads: pure functions, off the tick.
#pragma once

#include "haptics/curve/curve_set.h"

#include <array>
#include <vector>

namespace touchline {

/// Two nodes, not neighbours along an outline, whose boxes meet: each of `level`, or of its piece's
/// coarsest level if that is finer.
struct MeetingNodes {
    int level = 0;  // > 0
    std::array<SegmentRef, 2> nodes;
};

struct Meetings {
    std::vector<MeetingNodes> pairs;
    bool is_complete = true;  // false: too many to look for
};

/// A node over which something passes while its piece goes from `level` - 1 to `level`.
struct UnsafeNode {
    SegmentRef node;
    int level = 0;
};

struct SafeLevels {
    std::vector<int> coarsest;  // per piece: no change of level up to this one is unsafe
    std::vector<UnsafeNode> unsafe;
};

/// `meetings` holds all of the curves' nodes. Lines that already cross at level 0 may continue to;
/// no vertex passes over a line. O(pairs), each a few times.
[[nodiscard]] SafeLevels find_safe_levels(const CurveSet& curves, Meetings meetings);

/// Returns pins that separate the unsafe parts from the rest of their outline, so that the rest
/// keeps its levels. Returns none if the lost levels are coarser than a hand at 0.5 m/s asks for.
[[nodiscard]] std::vector<PinPlace> pins_for(const CurveSet& curves, const SafeLevels& safe);

}  // namespace touchline
