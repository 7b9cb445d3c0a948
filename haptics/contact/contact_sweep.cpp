// Finds what stops a servo step's motions: by a query, or among the neighbours of an edge that is
// alone.
#include "haptics/contact/contact_step.h"
#include "haptics/contact/sharp_tip.h"

#include <algorithm>

namespace touchline {

ContactStep::Sweep ContactStep::sweep(Position to, double radius_m, const Excluded& excluded,
                                      bool is_alone) {
    if (norm(to - proxy_.centre) <= still_m) return {};
    return is_alone ? sweep_neighbours(to, radius_m, excluded) : sweep_tree(to, radius_m, excluded);
}

ContactStep::Sweep ContactStep::sweep_tree(Position to, double radius_m, const Excluded& excluded) {
    if (queries_ == max_tree_queries) {
        report_->clear = 0.0;
        return {0.0, true, 0.0, {}};
    }
    ++queries_;
    const Motion motion{proxy_.centre, to, radius_m, outlines_.level(), excluded};
    const Hit hit = outlines_.scene().tree.first_hit(outlines_.scene().curves, motion, budget_);
    budget_.boxes -= hit.boxes;
    report_->boxes += hit.boxes;
    if (!hit.is_hit) report_->clear = std::min(report_->clear, hit.clear);
    Sweep result{hit.clear, !hit.is_hit && hit.clear < 1.0, hit.spare_m, {}};
    if (hit.is_hit) result.contact = contact_of(hit.segment, hit.touch);
    return result;
}

/// Only the neighbours along the outline are within reach: three each way cover the nodes beside
/// this one at a fractional level, one each way at a whole level.
ContactStep::Sweep ContactStep::sweep_neighbours(Position to, double radius_m,
                                                 const Excluded& excluded) {
    Sweep result;
    for (const SegmentRef& start : excluded) {
        for (const bool is_forward : {true, false}) {
            SegmentRef at = start;
            const int reached = outlines_.is_fractional() ? 3 : 1;
            for (int i = 0; i < reached && at.piece >= 0; ++i) {
                at = outlines_.next(at, is_forward);
                if (at.piece < 0 || at == excluded[0] || at == excluded[1]) continue;
                const auto found = touch(proxy_.centre, to, radius_m, outlines_.segment(at));
                if (!found || found->fraction >= result.share) continue;
                result = {found->fraction, false, 0.0, contact_of(at, *found)};
            }
        }
    }
    return result;
}

/// Although a smaller disc met nothing on its way, the whole disc may overlap something at the end.
/// Left there, it would sink a little at every pass.
std::optional<Contact> ContactStep::too_near(Position centre, double radius_m) {
    if (radius_m <= contact_skin_m || overlap_queries_ == max_tree_queries) return {};
    ++overlap_queries_;
    const Closest near =
        outlines_.scene().tree.closest_point(outlines_.scene().curves, centre, outlines_.level(),
                                             radius_m - approach_tolerance_m, budget_);
    budget_.boxes -= near.boxes;
    report_->boxes += near.boxes;
    if (near.segment.piece < 0) return {};
    const Segment s = outlines_.segment(near.segment);
    const Side side = cross(s.b - s.a, centre - near.point) < 0.0 ? Side::right : Side::left;
    const bool is_end = near.parameter == 0.0 || near.parameter == 1.0;
    return Contact{near.segment, near.parameter, side, normal_of(s, side), near.distance_m, is_end};
}

Contact ContactStep::contact_of(SegmentRef segment, Touch touch) {
    // A segment that is a point is the end of an edge beside it.
    if (is_point(outlines_.segment(segment))) [[unlikely]] {
        const SegmentRef before = outlines_.next(segment, false);
        segment = before.piece >= 0 ? before : outlines_.next(segment, true);
        touch.parameter = before.piece >= 0 ? 1.0 : 0.0;
    }
    if (const auto front = contact_in_front(outlines_, segment, touch)) return *front;
    // At a joint one edge alone is not enough: seen from a sharp tip, the normal may point to the
    // other side of either edge. It always lies on the outer side of the two together.
    Direction left = normal_of(outlines_.segment(segment), Side::left);
    if (touch.is_end) {
        const SegmentRef over = outlines_.next(segment, touch.parameter > 0.5);
        if (over.piece >= 0) left = left + normal_of(outlines_.segment(over), Side::left);
    }
    const Side side = dot(left, touch.normal) < 0.0 ? Side::right : Side::left;
    return {segment, touch.parameter, side, touch.normal, touch.distance_m, touch.is_end};
}

}  // namespace touchline
