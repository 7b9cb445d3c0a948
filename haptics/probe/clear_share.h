// Finds how far a turning edge may go before it comes too near to a line, by conservative
// advancement along separating directions. Threads: pure functions, no allocation.
#pragma once

#include "haptics/collision/capsule.h"
#include "haptics/probe/probe_pose.h"

namespace touchline {

/// An edge of the shape, in its frame, beside a line.
struct EdgeAndLine {
    Segment edge;
    Segment line;
    Separation at;  // where the motion starts
};

/// Returns the share of the move, at most `most`, over which the edge stays `keep_m` or more from
/// the line; 0 if it starts nearer than that and comes nearer still. `start` is `from` placed. Up
/// to that share the two stay apart at every moment: either along a fixed direction, where the
/// edge's ends stay beyond the line, or along one that turns with the edge, where the line's ends
/// do. Their approach is bounded by its rate at the start and their greatest acceleration.
[[nodiscard]] double clear_share(const EdgeAndLine& pair, const ProbePose& from,
                                 const ProbePlacement& start, const ProbeMove& move, double keep_m,
                                 double most);

}  // namespace touchline
