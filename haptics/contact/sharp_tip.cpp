#include "haptics/contact/sharp_tip.h"

namespace touchline {
namespace {

constexpr double sharp = 0.9;  // cosine of a tip's angle: one edge to a sweep

}  // namespace

std::optional<Contact> contact_in_front(RenderedOutlines& outlines, SegmentRef segment,
                                        const Touch& touch) {
    if (touch.is_end) return {};
    const bool at_end = touch.parameter > 0.5;
    const SegmentRef over = outlines.next(segment, at_end);
    if (over.piece < 0) return {};
    const Segment behind = outlines.segment(segment);
    const Segment front = outlines.segment(over);
    const Direction back = (at_end ? 1.0 : -1.0) * direction_of(front.b - front.a);
    const Direction along_it = (at_end ? 1.0 : -1.0) * direction_of(behind.b - behind.a);
    if (!(dot(back, touch.normal) > 0.0 && dot(back, along_it) < -sharp)) return {};
    const Foot on_front = foot(point_of(behind, touch.parameter), front);
    if (!(on_front.distance_m <= approach_tolerance_m)) return {};
    const bool is_right = dot(normal_of(front, Side::left), touch.normal) < 0.0;
    const Side side = is_right ? Side::right : Side::left;
    return Contact{over, on_front.parameter, side, normal_of(front, side), touch.distance_m, false};
}

}  // namespace touchline
