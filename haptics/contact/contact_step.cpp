#include "haptics/contact/contact_step.h"

#include "config/types/steady_clock.h"
#include "haptics/contact/friction.h"

#include <cmath>

namespace touchline {
namespace {

constexpr int longest_stride = 64;  // vertices between two looks at the clock: under 1 us

}  // namespace

Passage passage(Position vertex, Direction before, Direction after, double side_of_travel,
                double skin_m) {
    const Direction normal_before = side_of_travel * left_of(before);
    const Direction normal = side_of_travel * left_of(after);
    if (dot(after, normal_before) < 0.0) {  // convex
        return {vertex + along<Position>(normal_before, skin_m),
                vertex + along<Position>(normal, skin_m), normal, 0.0};
    }
    const double share = 1.0 / (1.0 + dot(normal_before, normal));
    const auto offset = along<Position>(share * (normal_before + normal), skin_m);
    return {vertex + offset, vertex + offset, normal, dot(offset, after)};
}

void ContactStep::run(Position handle, ContactReport& report) {
    handle_ = handle;
    report_ = &report;
    mark(proxy_.centre);
    Next next = Next::again;
    const int most_moves = 4 * budget_.walks;  // also arcs and changes of state
    for (int move = 0;
         move < most_moves && walks_ < budget_.walks && next == Next::again && !is_late(); ++move) {
        switch (proxy_.state) {
            case ContactState::free:
                next = move_free();
                break;
            case ContactState::edge:
                next = move_on_edge();
                break;
            case ContactState::vertex:
                next = proxy_.contact_count == 2 ? move_at_corner() : move_round();
                break;
        }
    }
    if (next == Next::again) report.carried_m = norm(handle_ - proxy_.centre);
}

ContactStep::Next ContactStep::move_free() {
    const double way_m = norm(handle_ - proxy_.centre);
    if (!(way_m > 0.0)) return Next::done;
    if (way_m < proxy_.spare_m) {
        proxy_.spare_m -= way_m;
        place(handle_);
        return Next::done;
    }
    const Sweep found = way_m > still_m ? sweep_tree(handle_, radius_m_, {}, proxy_.left) : Sweep{};
    if (found.contact || found.share > 0.0) proxy_.left = {};
    proxy_.spare_m = found.spare_m;
    if (found.contact) {
        first() = *found.contact;
        proxy_.contact_count = 1;
        enter(ContactState::edge);
        if (first().is_round) enter(ContactState::vertex);
        place_at_contact();
        return Next::again;
    }
    if (found.share >= 1.0) {
        place(handle_);
    } else {
        place(proxy_.centre + found.share * (handle_ - proxy_.centre));
        report_->carried_m = norm(handle_ - proxy_.centre);
    }
    return Next::done;
}

ContactStep::Next ContactStep::move_on_edge() {
    Course course = course_on_edge();
    if (course.depth_m >= 0.0 && is_thin(first())) {
        if (rest_on_edge(course)) return Next::done;
        const bool is_on = stride(course);
        if (is_on) course = course_on_edge();
        if ((is_on && rest_on_edge(course)) || rest_in_corner(course)) return Next::done;
        if (lift_off(course) || is_on) return Next::again;
    }
    ++walks_;
    if (course.depth_m < 0.0) return let_go();
    const double held_m = held_by_friction(settings_.friction, course.depth_m);
    if (std::abs(course.pulled_m) <= std::max(held_m, still_m)) return Next::done;
    return slide(course.pulled_m - std::copysign(held_m, course.pulled_m));
}

/// Goes `way_m` along the contact's edge, or to the end of the last edge in line with it. An edge
/// that is alone is the only one, because its sweeps look no further than its neighbours.
ContactStep::InLine ContactStep::go_in_line(double way_m) {
    InLine to{first(), way_m, 0};
    const Edge start = outlines_.edge(to.at.segment);
    const bool is_forward = way_m > 0.0;
    const double sign = is_forward ? 1.0 : -1.0;
    const double limit = is_forward ? 1.0 : 0.0;
    const int most = outlines_.is_alone(to.at.segment) ? 0 : budget_.walks - walks_;
    Edge edge = start;
    double left_m = std::abs(way_m);
    while (true) {
        const double to_end_m = std::abs(limit - to.at.parameter) * edge.length_m;
        if (left_m <= to_end_m) {
            const double share = sign * left_m * edge.per_length_m;
            to.at.parameter = std::clamp(to.at.parameter + share, 0.0, 1.0);
            return to;
        }
        left_m -= to_end_m;
        to.at.parameter = limit;
        const SegmentRef next =
            to.edges < most ? outlines_.next(edge.ref, is_forward) : SegmentRef{};
        if (next.piece < 0) break;
        edge = outlines_.edge(next);
        const Position end = is_forward ? edge.segment.b : edge.segment.a;
        const bool is_in_line = std::abs(cross(start.along, end - start.segment.a)) <= still_m &&
                                dot(start.along, edge.along) > 0.0;
        if (!is_in_line) break;
        ++to.edges;
        to.at.segment = next;
        to.at.parameter = 1.0 - limit;
        to.at.normal = normal_of(edge.segment, to.at.side);
    }
    to.way_m = sign * (std::abs(way_m) - left_m);
    return to;
}

/// The general slide, for whatever is near and however thick the proxy is. Edges in line are one
/// sweep.
ContactStep::Next ContactStep::slide(double way_m) {
    const Contact from = first();
    const InLine goal = go_in_line(way_m);
    walks_ += goal.edges;
    const Position to = point_of(outlines_.segment(goal.at.segment), goal.at.parameter) +
                        along<Position>(from.normal, from.offset_m);
    // If rounding has brought the disc nearer to the line, it counts as only that wide; else the
    // line's next edge would stop it.
    const Sweep found = sweep(to, std::min(radius_m_, from.offset_m),
                              {from.segment, goal.at.segment}, outlines_.is_alone(from.segment));
    first() = found.share >= 1.0 ? goal.at : go_in_line(found.share * goal.way_m).at;
    place_at_contact();
    if (found.contact || found.is_cut) {
        return arrive(found, std::abs(way_m) - found.share * std::abs(goal.way_m));
    }
    if (goal.way_m == way_m) return Next::done;
    return reach_end(way_m > 0.0);
}

bool ContactStep::is_late() const {
    return budget_.deadline_ns != 0 && steady_now_ns() >= budget_.deadline_ns;
}

/// Whether the proxy is a point except for its skin.
bool ContactStep::is_thin(const Contact& at) const {
    return radius_m_ == contact_skin_m && at.offset_m <= 1.5 * contact_skin_m &&
           at.offset_m >= 0.5 * contact_skin_m;
}

ContactStep::Course ContactStep::course_on_edge() {
    const Contact& at = first();
    const Position pull = handle_ - proxy_.centre;
    const Edge& edge = outlines_.edge(at.segment);
    Course course;
    course.pulled_m = dot(pull, edge.along);
    course.is_forward = course.pulled_m > 0.0;
    course.depth_m = -dot(pull, at.normal);
    course.way_m = std::abs(course.pulled_m) - held_by_friction(settings_.friction, course.depth_m);
    course.left_m = (course.is_forward ? 1.0 - at.parameter : at.parameter) * edge.length_m;
    return course;
}

/// A slide that stops short of the end of an open edge, and so needs no sweep. Returns false, and
/// does nothing, if there is more to it.
bool ContactStep::rest_on_edge(const Course& course) {
    Contact& at = first();
    const bool is_short = course.way_m > 0.0 && course.way_m + 2.0 * at.offset_m <= course.left_m;
    if (!(course.depth_m >= 0.0 && is_short)) return false;
    if (!outlines_.is_open(at.segment, course.is_forward)) return false;
    const Edge& edge = outlines_.edge(at.segment);
    at.parameter += std::copysign(course.way_m * edge.per_length_m, course.pulled_m);
    place_at_contact(edge.segment);
    return true;
}

/// Passes as many vertices as the handle clearly pulls a thin proxy over. Returns false, and does
/// nothing, if there are none.
bool ContactStep::stride(const Course& course) {
    Contact& at = first();
    const EdgeRow& row = outlines_.row(at.segment.piece);
    if (row.points.empty() || !outlines_.is_alone(at.segment)) return false;
    const bool is_forward = course.is_forward;
    if (!(course.left_m > 3.0 * at.offset_m)) return false;
    const Pull pull{handle_, at.side, settings_.friction};
    const int step = is_forward ? 1 : -1;
    int last = at.segment.index - step;  // edge before a vertex that is passed
    bool is_on = true;
    while (is_on && walks_ < budget_.walks && !is_late()) {
        const int passed = vertices_passed(row, outlines_.scene().tree, last + step, is_forward,
                                           pull, std::min(longest_stride, budget_.walks - walks_));
        is_on = passed == longest_stride;
        last += step * passed;
        walks_ += passed;
    }
    if (last == at.segment.index - step) return false;
    if (path_ != nullptr) {
        for (int index = at.segment.index; index != last; index += step) {
            mark(passage_after(index, step));
        }
    }
    const Passage end = passage_after(last, step);
    if (path_ != nullptr) mark(end);
    at.segment.index = last + step;
    at.normal = end.normal;
    const double inset = end.inset_m * outlines_.edge(at.segment).per_length_m;
    at.parameter = is_forward ? inset : 1.0 - inset;
    proxy_.centre = end.enter;
    return true;
}

/// Goes into a concave vertex at the end of an open edge if the handle does not pull a thin proxy
/// on: both edges hold it. Returns false, and does nothing, if there is more to it.
bool ContactStep::rest_in_corner(const Course& course) {
    Contact& at = first();
    const Edge edge = outlines_.edge(at.segment);
    const bool is_forward = course.is_forward;
    if (!course.is_past_end() || !outlines_.is_open(at.segment, is_forward)) return false;
    const SegmentRef next = outlines_.next(at.segment, is_forward);
    if (next.piece < 0) return false;
    const double sign = is_forward ? 1.0 : -1.0;
    const Edge& ahead = outlines_.edge(next);
    const Direction before = sign * edge.along;
    const Direction after = sign * ahead.along;
    if (dot(after, at.normal) < 0.0 || !(dot(before, after) > 0.1)) return false;
    const Passage corner = passage(is_forward ? edge.segment.b : edge.segment.a, before, after,
                                   sign * sign_of(at.side), at.offset_m);
    const Position pull_there = handle_ - corner.enter;
    const double depth = -dot(pull_there, corner.normal);
    const bool is_pulled_on =
        depth >= 0.0 && dot(pull_there, after) > held_by_friction(settings_.friction, depth);
    const double inset_m = corner.inset_m;
    if (is_pulled_on || inset_m > course.left_m || 2.0 * inset_m > ahead.length_m) return false;
    const double end = inset_m * edge.per_length_m;
    const double start = inset_m * ahead.per_length_m;
    at.parameter = is_forward ? 1.0 - end : end;
    proxy_.contacts[1] = {
        next, is_forward ? start : 1.0 - start, at.side, corner.normal, at.offset_m, false};
    proxy_.contact_count = 2;
    enter(ContactState::vertex);
    place(corner.enter);
    return true;
}

/// Leaves a thin proxy's edge at a convex vertex if the handle, pulling past its end, does not
/// press on the next edge. Returns false, and does nothing, if there is more to it.
bool ContactStep::lift_off(const Course& course) {
    const Contact& at = first();
    const Edge edge = outlines_.edge(at.segment);
    const bool is_forward = course.is_forward;
    if (!course.is_past_end() || !outlines_.is_open(at.segment, is_forward)) return false;
    const SegmentRef next = outlines_.next(at.segment, is_forward);
    if (next.piece < 0 || !outlines_.is_alone(next)) return false;
    const double sign = is_forward ? 1.0 : -1.0;
    const Segment ahead = outlines_.segment(next);
    const Position after = sign * (ahead.b - ahead.a);
    const double length_m = norm(after);
    const Position vertex = is_forward ? edge.segment.b : edge.segment.a;
    const Position to_handle = handle_ - vertex;
    const double distance_m = norm(to_handle);
    const bool is_long = std::min(length_m, distance_m) > 8.0 * at.offset_m;
    const bool is_convex = dot(after, at.normal) < 0.0;
    // Times the next edge's length.
    const double off_m2 = sign * sign_of(at.side) * cross(after, to_handle);
    if (!(is_long && is_convex && off_m2 > 2.0 * at.offset_m * length_m)) return false;
    // The proxy leaves the arc round the vertex where the handle pulls along the tangent.
    const Direction ahead_of = along<Direction>(to_handle, 1.0 / distance_m);
    const Direction left = left_of(ahead_of);
    const double cosine = at.offset_m / distance_m;
    const double sine = std::copysign(std::sqrt(1.0 - cosine * cosine), dot(left, at.normal));
    ++walks_;
    place(vertex + along<Position>(at.normal, at.offset_m));
    place(vertex + along<Position>(cosine * ahead_of + sine * left, at.offset_m));
    let_go();
    return true;
}

/// From one edge of the contact's piece to the next, up the row (step 1) or down (-1).
Passage ContactStep::passage_after(int index, int step) {
    const Contact& at = first();
    const double sign = step;
    const Direction before = sign * outlines_.edge({at.segment.piece, index}).along;
    const Edge& after = outlines_.edge({at.segment.piece, index + step});
    return passage(step > 0 ? after.segment.a : after.segment.b, before, sign * after.along,
                   sign * sign_of(at.side), at.offset_m);
}

/// A vertex is left over its edge.
ContactStep::Next ContactStep::let_go() {
    proxy_.left = first().segment;
    proxy_.contact_count = 0;
    enter(ContactState::edge);
    enter(ContactState::free);
    return Next::again;
}

void ContactStep::enter(ContactState state) {
    proxy_.state = state;
    report_->transitions.add(state);
}

void ContactStep::mark(Position way_point) {
    if (path_ != nullptr) path_->push_back(way_point);
}

void ContactStep::mark(const Passage& passed) {
    mark(passed.leave);
    mark(passed.enter);
}

void ContactStep::place(Position centre) {
    if (path_ != nullptr && centre != proxy_.centre) mark(centre);
    proxy_.centre = centre;
}

void ContactStep::place_at_contact() {
    place_at_contact(outlines_.segment(first().segment));
}

void ContactStep::place_at_contact(const Segment& segment) {
    place(centre_of(segment, first()));
}

/// Finds what stops a motion: by a query, or among the neighbours of an edge that is alone.
ContactStep::Sweep ContactStep::sweep(Position to, double radius_m, const Excluded& excluded,
                                      bool is_alone) {
    if (norm(to - proxy_.centre) <= still_m) return {};
    return is_alone ? sweep_neighbours(to, radius_m, excluded)
                    : sweep_tree(to, radius_m, excluded, {});
}

ContactStep::Sweep ContactStep::sweep_tree(Position to, double radius_m, const Excluded& excluded,
                                           SegmentRef start) {
    if (queries_ == max_tree_queries) {
        report_->clear = 0.0;
        return {0.0, true, 0.0, {}};
    }
    ++queries_;
    const Motion motion{proxy_.centre, to, radius_m, outlines_.level(), excluded};
    const Scene& scene = outlines_.scene();
    const Hit hit = start.piece < 0
                        ? scene.tree.first_hit(scene.curves, motion, budget_)
                        : scene.tree.first_hit_from(scene.curves, motion, start, budget_);
    budget_.boxes -= hit.boxes;
    report_->boxes += hit.boxes;
    if (!hit.is_hit) report_->clear = std::min(report_->clear, hit.clear);
    Sweep result{hit.clear, !hit.is_hit && hit.clear < 1.0, hit.spare_m, {}};
    if (hit.is_hit) result.contact = contact_of(hit.segment, hit.touch);
    return result;
}

/// Only the neighbours along the outline are within reach: those in the nodes beside this one.
ContactStep::Sweep ContactStep::sweep_neighbours(Position to, double radius_m,
                                                 const Excluded& excluded) {
    Sweep result;
    const int reached = outlines_.is_fractional() ? halves_beside : 1;
    const auto next = [&](SegmentRef at, bool is_forward) {
        return outlines_.next(at, is_forward);
    };
    visit_beside(excluded, reached, next, [&](SegmentRef at) {
        const auto found = touch(proxy_.centre, to, radius_m, outlines_.segment(at));
        if (!found || found->fraction >= result.share) return;
        result = {found->fraction, false, 0.0, contact_of(at, *found)};
    });
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
