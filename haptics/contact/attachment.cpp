#include "haptics/contact/attachment.h"

#include "haptics/contact/proxy_state.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace touchline {
namespace {

constexpr int max_segments = 256;  // slid over in a tick

/// Where a slide along one segment ends.
struct Slide {
    Attachment at;
    double way_m = 0.0;
};

/// Goes on to the neighbour ahead (behind) if the foot there is nearer than the one here: to its
/// near end if this segment's end is reached, or, inside a bend, to the foot itself.
std::optional<Slide> onward(RenderedOutlines& outlines, const Attachment& at, const Foot& here,
                            Position handle, bool is_forward) {
    const SegmentRef next = outlines.next(at.segment, is_forward);
    if (next.piece < 0) return {};
    const Segment s = outlines.segment(next);
    const Foot there = foot(handle, s);
    if (!(there.distance_m < here.distance_m)) return {};
    const Position joint = is_forward ? s.a : s.b;
    const double near_end = is_forward ? 0.0 : 1.0;
    if (at.parameter == 1.0 - near_end) return Slide{{next, near_end}, 0.0};
    return Slide{{next, there.parameter}, norm(joint - here.point) + norm(there.point - joint)};
}

}  // namespace

Position point_of(RenderedOutlines& outlines, const Attachment& at) {
    return point_of(outlines.segment(at.segment), at.parameter);
}

Attachment slid(RenderedOutlines& outlines, Attachment at, Position handle, double longest_m,
                double longest_hop_m) {
    double left_m = longest_m;
    for (int i = 0; i < max_segments; ++i) {
        const Segment s = outlines.segment(at.segment);
        const Foot here = foot(handle, s);
        const double length_m = norm(s.b - s.a);
        const double way = here.parameter - at.parameter;
        if (!(std::abs(way) * length_m <= left_m)) {
            at.parameter += std::copysign(left_m / length_m, way);
            return at;
        }
        left_m -= std::abs(way) * length_m;
        at.parameter = here.parameter;
        auto next = onward(outlines, at, here, handle, true);
        if (!next) next = onward(outlines, at, here, handle, false);
        if (!next || !(next->way_m <= longest_hop_m)) return at;
        longest_hop_m -= next->way_m;
        at = next->at;
    }
    return at;
}

Attachment at_level(const CurveSet& curves, const Attachment& at, double from, double to) {
    const int piece = at.segment.piece;
    const double parameter = curves.outline_parameter(piece, from, at.segment.index, at.parameter);
    const double from_start =
        parameter - curves.pieces()[static_cast<std::size_t>(piece)].first_parameter;
    const int stride = 1 << static_cast<int>(curves.rendered_level(piece, to));
    const int last = curves.rendered_count(piece, to) - 1;
    const int index = std::clamp(static_cast<int>(from_start / stride), 0, last);
    const double begin = curves.outline_parameter(piece, to, index, 0.0);
    const double end = curves.outline_parameter(piece, to, index, 1.0);
    return {{piece, index}, std::clamp((parameter - begin) / (end - begin), 0.0, 1.0)};
}

}  // namespace touchline
