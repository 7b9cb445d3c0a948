// The point of a line that the hand is tied to: a bead on the outline as rendered. It slides
// towards the hand and stays on the curve when the level changes. Threads: one, the servo's. No
// allocation.
#pragma once

#include "config/types/vec2.h"
#include "haptics/contact/rendered_outlines.h"

namespace touchline {

struct Attachment {
    SegmentRef segment;      // piece -1: none
    double parameter = 0.0;  // on the segment, 0 ... 1

    [[nodiscard]] bool exists() const { return segment.piece >= 0; }
};

[[nodiscard]] Position point_of(RenderedOutlines& outlines, const Attachment& at);

/// Slides the attachment along its outline while that brings it nearer to the hand: at most
/// `longest_m` and 256 segments. Inside a bend, where the way over the vertex first leads away from
/// the hand, it hops to the next segment's nearest point, at most `longest_hop_m` further on. The
/// distance to the hand never grows.
[[nodiscard]] Attachment slid(RenderedOutlines& outlines, Attachment at, Position handle,
                              double longest_m, double longest_hop_m);

/// Returns the attachment at the same parameter of the outline, on the curve as rendered at level
/// `to`. O(1).
[[nodiscard]] Attachment at_level(const CurveSet& curves, const Attachment& at, double from,
                                  double to);

}  // namespace touchline
