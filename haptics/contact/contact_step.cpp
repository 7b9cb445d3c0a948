#include "haptics/contact/contact_step.h"

#include "config/types/steady_clock.h"
#include "haptics/contact/round_vertex.h"
#include "haptics/contact/sharp_tip.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

constexpr double still_m = 1e-14;    // a motion this short is rounding
constexpr double parallel = 1e-9;    // sine of an angle too small to tell
constexpr double passing_m = 1e-17;  // nearer to an end on a way past it: rounding
constexpr double same_end = 1e-14;   // the same where two ends touch a disc: rounding
constexpr int longest_stride = 64;   // vertices between two looks at the clock: under 1 us
constexpr int max_visits = 6;        // tries to leave one corner in a step, one per line there

constexpr int touch_halvings = 40;  // 15 degrees to 1e-13

/// The way of a disc's centre round a vertex.
struct Arc {
    Position vertex;
    double offset_m = 0.0;  // of the centre from it
    double radius_m = 0.0;  // of the disc
};

/// On an arc about `vertex` a disc is swept along a chord and smaller by the chord's sagitta, so
/// that what stops it is met late, at normal `met`: the last normal from `from` on at which the
/// whole disc keeps its radius from it, or what it kept at the start.
Direction back_to_touch(const Arc& arc, Direction from, Direction met, const Segment& obstacle) {
    const auto distance_m = [&](Direction normal) {
        return foot(arc.vertex + along<Position>(normal, arc.offset_m), obstacle).distance_m;
    };
    const double kept_m = std::min(arc.radius_m, distance_m(from));
    if (distance_m(met) >= kept_m) return met;
    Direction last = from;
    double before = 0.0;  // shares of the way between the two normals
    double after = 1.0;
    for (int i = 0; i < touch_halvings; ++i) {
        const double share = 0.5 * (before + after);
        const Direction normal = direction_of((1.0 - share) * from + share * met);
        const bool is_clear = distance_m(normal) >= kept_m;
        if (is_clear) last = normal;
        (is_clear ? before : after) = share;
    }
    return last;
}

}  // namespace

void ContactStep::run(Position handle, ContactReport& report) {
    handle_ = handle;
    report_ = &report;
    mark(proxy_.centre);
    Next next = Next::again;
    for (int move = 0; move < max_moves && walks_ < max_walks && next == Next::again && !is_late();
         ++move) {
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
    const Sweep found = sweep(handle_, radius_m_, {}, false);
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
    if (is_thin(first())) {
        if (rest_on_edge()) return Next::done;
        const bool is_on = stride();
        if ((is_on && rest_on_edge()) || rest_in_corner()) return Next::done;
        if (is_on) return Next::again;
    }
    ++walks_;
    const Contact& at = first();
    const Position pull = handle_ - proxy_.centre;
    const double depth = -dot(pull, at.normal);
    if (depth < 0.0) {
        proxy_.contact_count = 0;
        enter(ContactState::free);
        return Next::again;
    }
    const Segment s = outlines_.segment(at.segment);
    const double way_m = dot(pull, direction_of(s.b - s.a));
    const double held_m = settings_.friction * depth;
    if (std::abs(way_m) <= std::max(held_m, still_m)) return Next::done;
    return slide(way_m - std::copysign(held_m, way_m));
}

/// `way_m` along the contact's edge, or to the end of the last edge that lies in line with it. An
/// edge that is alone is the only one: its sweeps look no further than its neighbours.
ContactStep::InLine ContactStep::go_in_line(double way_m) {
    InLine to{first(), way_m, 0};
    const Edge start = outlines_.edge(to.at.segment);
    const bool is_forward = way_m > 0.0;
    const double sign = is_forward ? 1.0 : -1.0;
    const double limit = is_forward ? 1.0 : 0.0;
    const int most = outlines_.is_alone(to.at.segment) ? 0 : max_walks - walks_;
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

/// A slide in general: whatever is near, however thick the proxy. Edges in line are one sweep.
ContactStep::Next ContactStep::slide(double way_m) {
    const Contact from = first();
    const InLine goal = go_in_line(way_m);
    walks_ += goal.edges;
    const Position to = point_of(outlines_.segment(goal.at.segment), goal.at.parameter) +
                        along<Position>(from.normal, from.offset_m);
    // What has come nearer to the line by rounding is no wider than that, or the line's next edge
    // would stop it.
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

/// The proxy is a point but for its skin.
bool ContactStep::is_thin(const Contact& at) const {
    return radius_m_ == contact_skin_m && at.offset_m <= 1.5 * contact_skin_m &&
           at.offset_m >= 0.5 * contact_skin_m;
}

/// A slide that stops short of the end of an open edge: it needs no sweep. False, and nothing done,
/// where that is not all there is to it.
bool ContactStep::rest_on_edge() {
    Contact& at = first();
    const Edge& edge = outlines_.edge(at.segment);
    const Position pull = handle_ - proxy_.centre;
    const double depth = -dot(pull, at.normal);
    const double pulled_m = dot(pull, edge.along);
    const double way_m = std::abs(pulled_m) - settings_.friction * depth;
    const bool is_forward = pulled_m > 0.0;
    const double left_m = (is_forward ? 1.0 - at.parameter : at.parameter) * edge.length_m;
    const bool is_short = way_m > 0.0 && way_m + 2.0 * at.offset_m <= left_m;
    if (!(depth >= 0.0 && is_short)) return false;
    if (!(is_forward ? edge.is_open_ahead : edge.is_open_behind)) return false;
    at.parameter += std::copysign(way_m * edge.per_length_m, pulled_m);
    place_at_contact(edge.segment);
    return true;
}

/// Over as many vertices as the handle clearly pulls a thin proxy. False, and nothing done, where
/// there is none.
bool ContactStep::stride() {
    Contact& at = first();
    const EdgeRow& row = outlines_.row(at.segment.piece);
    if (row.points.empty() || !outlines_.is_alone(at.segment)) return false;
    const Edge edge = outlines_.edge(at.segment);
    const bool is_forward = dot(handle_ - proxy_.centre, edge.along) > 0.0;
    const double left_m = (is_forward ? 1.0 - at.parameter : at.parameter) * edge.length_m;
    if (!(left_m > 3.0 * at.offset_m)) return false;
    const int passed = vertices_passed(row, outlines_.scene().tree, at.segment.index, is_forward,
                                       {handle_, at.side, settings_.friction},
                                       std::min(longest_stride, max_walks - walks_));
    if (passed == 0) return false;
    walks_ += passed;
    const int step = is_forward ? 1 : -1;
    const int last = at.segment.index + step * (passed - 1);
    if (path_ != nullptr) {
        for (int index = at.segment.index; index != last; index += step) {
            mark(passage_after(index, step));
        }
    }
    const Passage end = passage_after(last, step);
    mark(end);
    at.segment.index = last + step;
    at.normal = end.normal;
    const double inset = end.inset_m * outlines_.edge(at.segment).per_length_m;
    at.parameter = is_forward ? inset : 1.0 - inset;
    proxy_.centre = end.enter;
    return true;
}

/// Into a concave vertex at the end of an open edge, where the handle does not pull a thin proxy
/// on: both edges hold it. False, and nothing done, where that is not all there is to it.
bool ContactStep::rest_in_corner() {
    Contact& at = first();
    const Edge edge = outlines_.edge(at.segment);
    const Position pull = handle_ - proxy_.centre;
    const double pulled_m = dot(pull, edge.along);
    const bool is_forward = pulled_m > 0.0;
    if (!(is_forward ? edge.is_open_ahead : edge.is_open_behind)) return false;
    const SegmentRef next = outlines_.next(at.segment, is_forward);
    if (next.piece < 0) return false;
    const double left_m = (is_forward ? 1.0 - at.parameter : at.parameter) * edge.length_m;
    const double depth_here = -dot(pull, at.normal);
    const double way_m = std::abs(pulled_m) - settings_.friction * depth_here;
    if (!(depth_here >= 0.0 && way_m > left_m)) return false;
    const double sign = is_forward ? 1.0 : -1.0;
    const Edge& ahead = outlines_.edge(next);
    const Direction before = sign * edge.along;
    const Direction after = sign * ahead.along;
    if (dot(after, at.normal) < 0.0 || !(dot(before, after) > 0.1)) return false;
    const Passage corner = passage(is_forward ? edge.segment.b : edge.segment.a, before, after,
                                   sign * sign_of(at.side), at.offset_m);
    const Position pull_there = handle_ - corner.enter;
    const double depth = -dot(pull_there, corner.normal);
    const bool is_pulled_on = depth >= 0.0 && dot(pull_there, after) > settings_.friction * depth;
    const double inset_m = corner.inset_m;
    if (is_pulled_on || inset_m > left_m || 2.0 * inset_m > ahead.length_m) return false;
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

/// From one edge of the contact's piece to the next, up (step 1) or down the row (-1).
Passage ContactStep::passage_after(int index, int step) {
    const Contact& at = first();
    const Segment before = outlines_.segment({at.segment.piece, index});
    const Segment after = outlines_.segment({at.segment.piece, index + step});
    const double sign = step;
    return passage(step > 0 ? before.b : before.a, direction_of(sign * (before.b - before.a)),
                   direction_of(sign * (after.b - after.a)), sign * sign_of(at.side), at.offset_m);
}

/// Stopped on the way by a second contact, or by the budget with `left_m` to go.
ContactStep::Next ContactStep::arrive(const Sweep& sweep, double left_m) {
    if (!sweep.contact) {
        report_->carried_m = left_m;
        return Next::done;
    }
    // Seen from where the centre came to lie, which on an arc is not quite where the sweep stopped.
    Contact second = *sweep.contact;
    const Segment segment = outlines_.segment(second.segment);
    const Foot at = foot(proxy_.centre, segment);
    const double aside_m = dot(proxy_.centre - at.point, direction_of(segment.b - segment.a));
    const bool is_end = at.parameter == 0.0 || at.parameter == 1.0;
    second.is_round = is_end && (second.is_round || std::abs(aside_m) > still_m);
    second.parameter = at.parameter;
    if (second.is_round && at.distance_m > 0.0) {
        second.offset_m = at.distance_m;
        second.normal = along<Direction>(proxy_.centre - at.point, 1.0 / at.distance_m);
    } else {
        second.normal = normal_of(segment, second.side);
        second.offset_m = dot(proxy_.centre - at.point, second.normal);
    }
    proxy_.contacts[1] = second;
    proxy_.contact_count = 2;
    enter(ContactState::vertex);
    return Next::again;
}

/// At the end of the edge: round it where the outline turns away or ends, else go on or hold.
ContactStep::Next ContactStep::reach_end(bool is_forward) {
    Contact& at = first();
    const SegmentRef next = outlines_.next(at.segment, is_forward);
    if (next.piece < 0) {
        at.is_round = true;
        enter(ContactState::vertex);
        return Next::again;
    }
    const Segment s = outlines_.segment(next);
    const Direction normal = normal_of(s, at.side);
    const Direction away = (is_forward ? 1.0 : -1.0) * direction_of(s.b - s.a);
    const double arc = at.offset_m * norm(normal - at.normal);
    // An outline that runs back on itself turns away to neither side: it is rounded like an end.
    const bool runs_back = dot(normal, at.normal) < 0.0 && dot(away, at.normal) < parallel;
    if ((dot(away, at.normal) < 0.0 || runs_back) && arc > approach_tolerance_m) {
        at.is_round = true;
        enter(ContactState::vertex);
        return Next::again;
    }
    return walk_or_hold(next, is_forward, away, normal);
}

/// The next edge goes on almost straight, or bends towards the proxy by less than a sweep can tell.
ContactStep::Next ContactStep::walk_or_hold(SegmentRef next, bool at_start, Direction away,
                                            Direction normal) {
    const Contact& at = first();
    const Contact ahead{next, at_start ? 0.0 : 1.0, at.side, normal, at.offset_m, false};
    const double depth = -dot(handle_ - proxy_.centre, at.normal);
    if (dot(handle_ - proxy_.centre, away) > settings_.friction * depth) {
        first() = ahead;
        place_at_contact();
        return Next::again;
    }
    proxy_.contacts[1] = ahead;
    proxy_.contact_count = 2;
    enter(ContactState::vertex);
    return Next::done;
}

ContactStep::Next ContactStep::move_round() {
    Contact& at = first();
    const Position vertex = point_of(outlines_.segment(at.segment), at.parameter);
    const Position pull = handle_ - vertex;
    if (dot(pull, at.normal) > at.offset_m) {
        proxy_.contact_count = 0;
        enter(ContactState::edge);
        enter(ContactState::free);
        return Next::again;
    }
    Contact left_edge;
    Contact right_edge;
    const double to_left = arc_to(at, 1.0, left_edge);
    const double to_right = arc_to(at, -1.0, right_edge);
    const ArcGoal goal =
        arc_goal(at.normal, pull, at.offset_m, to_left, to_right, settings_.friction);
    if (goal.turn == 0.0) return Next::done;
    const double step = std::min(goal.angle_rad, largest_arc_step_rad(at.offset_m));
    const Direction from = at.normal;
    const Direction to = turned(from, goal.turn * step);
    const Contact edge = goal.turn > 0.0 ? left_edge : right_edge;
    const Contact other = goal.turn > 0.0 ? right_edge : left_edge;
    const bool is_alone =
        outlines_.is_alone(left_edge.segment) && outlines_.is_alone(right_edge.segment);
    // The chord passes nearer to the vertex than the arc; the disc is taken that much smaller, so
    // that other lines through the same vertex do not stop it.
    const double chord_radius = std::min(radius_m_, at.offset_m) * std::cos(0.5 * step);
    const Sweep found = sweep(vertex + along<Position>(to, at.offset_m), chord_radius,
                              {edge.segment, other.segment}, is_alone);
    at.normal =
        found.share >= 1.0 ? to : direction_of((1.0 - found.share) * from + found.share * to);
    if (found.contact) {
        const Arc arc{vertex, at.offset_m, std::min(radius_m_, at.offset_m)};
        at.normal = back_to_touch(arc, from, at.normal, outlines_.segment(found.contact->segment));
    }
    place_at_contact();
    if (found.contact || found.is_cut) {
        return arrive(found, at.offset_m * (goal.angle_rad - found.share * step));
    }
    if (step < goal.angle_rad) return Next::again;
    switch (goal.end) {
        case ArcGoal::End::rest:
            return Next::done;
        case ArcGoal::End::edge:
            first() = edge;
            // Touched beside the vertex, beyond the arc: it stays beside it.
            if (step == 0.0) {
                const Foot below = foot(proxy_.centre, outlines_.segment(edge.segment));
                first().parameter = below.parameter;
                // No further off than it is, or it would move away from the handle.
                if (below.distance_m < at.offset_m - approach_tolerance_m) {
                    first().offset_m = below.distance_m;
                }
            }
            enter(ContactState::edge);
            place_at_contact();
            return Next::again;
        case ArcGoal::End::free:
            proxy_.contact_count = 0;
            enter(ContactState::edge);
            enter(ContactState::free);
            return Next::again;
    }
    return Next::done;
}

/// Angle from a round contact to the end of its arc, turning left or right, and the edge found
/// there.
double ContactStep::arc_to(const Contact& at, double turn, Contact& edge) {
    const bool at_end = at.parameter > 0.5;  // of its own segment
    // Seen from the left of the outline the edge before a convex vertex lies to the left of the
    // vertex's normal, the edge after it to the right; from the right side the other way round.
    const bool wants_before = turn * sign_of(at.side) > 0.0;
    edge = at;
    edge.is_round = false;
    if (wants_before != at_end) {
        const SegmentRef over = outlines_.next(at.segment, !wants_before);
        if (over.piece < 0) {  // round a line's end, to the other side of the same edge
            edge.side = at.side == Side::left ? Side::right : Side::left;
        } else {
            edge.segment = over;
            edge.parameter = wants_before ? 1.0 : 0.0;
        }
    }
    edge.normal = normal_of(outlines_.segment(edge.segment), edge.side);
    return angle_between(at.normal, edge.normal, turn);
}

ContactStep::Next ContactStep::move_at_corner() {
    const Position pull = handle_ - proxy_.centre;
    if (!(norm(proxy_.centre - last_corner_) <= still_m)) visits_ = 0;
    if (++visits_ > max_visits) {
        report_->carried_m = norm(pull);
        return Next::done;
    }
    last_corner_ = proxy_.centre;
    const Contact a = proxy_.contacts[0];
    const Contact b = proxy_.contacts[1];
    if (dot(pull, a.normal) >= 0.0 && dot(pull, b.normal) >= 0.0) {
        if (!(norm(pull) > 0.0)) return Next::done;
        proxy_.contact_count = 0;
        enter(ContactState::edge);
        enter(ContactState::free);
        return Next::again;
    }
    double pull_a = 0.0;
    double pull_b = 0.0;
    const bool can_a = can_slide(a, b, pull_a);
    const bool can_b = can_slide(b, a, pull_b);
    if (!can_a && !can_b) return Next::done;
    // The greater pull; where that has led back here, the other one.
    const bool wants_a = (pull_a >= pull_b) == (visits_ % 2 == 1);
    leave_corner(can_a && (!can_b || wants_a) ? 0 : 1);
    return Next::again;
}

/// True when the handle pulls the proxy along one contact, pressed on it and away from the other.
bool ContactStep::can_slide(const Contact& along_this, const Contact& other, double& pull_m) const {
    const Position pull = handle_ - proxy_.centre;
    const double depth = -dot(pull, along_this.normal);
    const double sideways = cross(along_this.normal, pull);
    pull_m = std::abs(sideways) - settings_.friction * std::max(depth, 0.0);
    const Direction way = std::copysign(1.0, sideways) * left_of(along_this.normal);
    // Round an end the way bends down at once: never into a line that it starts along.
    double least = -parallel;
    if (along_this.is_round) least = other.is_round ? -same_end : parallel;
    // Past an end almost at right angles to it, which comes nearer to it by rounding only.
    if (!along_this.is_round && other.is_round) {
        least = std::min(least, -std::sqrt(2.0 * passing_m / other.offset_m));
    }
    return depth >= 0.0 && pull_m > still_m && dot(way, other.normal) >= least;
}

void ContactStep::leave_corner(std::size_t kept) {
    first() = proxy_.contacts[kept];
    proxy_.contact_count = 1;
    if (!first().is_round) enter(ContactState::edge);
}

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

/// Nothing but the neighbours along the outline is within reach: three each way cover the nodes
/// beside this one at a fractional level, one at a whole level.
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

Contact ContactStep::contact_of(SegmentRef segment, Touch touch) {
    // A segment that is a point is the end of an edge beside it.
    if (is_point(outlines_.segment(segment))) [[unlikely]] {
        const SegmentRef before = outlines_.next(segment, false);
        segment = before.piece >= 0 ? before : outlines_.next(segment, true);
        touch.parameter = before.piece >= 0 ? 1.0 : 0.0;
    }
    if (const auto front = contact_in_front(outlines_, segment, touch)) return *front;
    // At a joint an edge alone cannot tell: seen from a sharp tip the normal may point to the other
    // side of either edge. It always lies on the outer side of the two together.
    Direction left = normal_of(outlines_.segment(segment), Side::left);
    if (touch.is_end) {
        const SegmentRef over = outlines_.next(segment, touch.parameter > 0.5);
        if (over.piece >= 0) left = left + normal_of(outlines_.segment(over), Side::left);
    }
    const Side side = dot(left, touch.normal) < 0.0 ? Side::right : Side::left;
    return {segment, touch.parameter, side, touch.normal, touch.distance_m, touch.is_end};
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
    if (centre == proxy_.centre) return;
    proxy_.centre = centre;
    mark(centre);
}

void ContactStep::place_at_contact() {
    place_at_contact(outlines_.segment(first().segment));
}

void ContactStep::place_at_contact(const Segment& segment) {
    const Contact& at = first();
    place(point_of(segment, at.parameter) + along<Position>(at.normal, at.offset_m));
}

}  // namespace touchline
