// The arithmetic of vertices, and state 2 of a servo step: at the end of an edge, round a vertex,
// or held by two contacts.
#include "haptics/contact/contact_step.h"
#include "haptics/contact/friction.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

constexpr double rest_m = 1e-15;  // a pull this small along the arc moves nothing

constexpr double sharp = 0.9;  // cosine of a tip's angle: one edge to a sweep

constexpr double parallel = 1e-9;    // sine of an angle too small to tell
constexpr double same_end = 1e-14;   // the same where two ends touch a disc: rounding
constexpr double passing_m = 1e-17;  // nearer to an end on a way past it: rounding
constexpr int max_visits =
    6;  // tries to leave one corner in a step, one per line that may meet there
constexpr double sunk_m = 1e-10;    // less is not worth a query
constexpr int touch_halvings = 40;  // 15 degrees to 1e-13

/// The way of a disc's centre round a vertex.
struct Arc {
    Position vertex;
    double offset_m = 0.0;  // of the centre from it
    double radius_m = 0.0;  // of the disc
};

/// On an arc about `vertex`, a disc is swept along a chord and is smaller by the chord's sagitta,
/// so it meets what stops it late, at normal `met`. Returns the last normal from `from` on at which
/// the whole disc keeps its radius from the obstacle, or the distance that it kept at the start.
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

double largest_arc_step_rad(double offset_m) {
    constexpr double unfelt_m = 1e-9;
    return offset_m > unfelt_m ? std::numbers::pi / 12.0 : std::numbers::pi / 2.0;
}

Direction turned(Direction n, double angle_rad) {
    const double c = std::cos(angle_rad);
    const double s = std::sin(angle_rad);
    return {c * n.x - s * n.y, s * n.x + c * n.y};
}

double angle_between(Direction n, Direction m, double turn) {
    constexpr double full = 2.0 * std::numbers::pi;
    double angle = std::atan2(turn * cross(n, m), dot(n, m));
    if (angle < 0.0) angle += full;
    return angle > 0.875 * full ? 0.0 : angle;
}

ArcGoal arc_goal(Direction n, Position pull, double offset_m, double to_left_rad,
                 double to_right_rad, double friction) {
    const double sideways = cross(n, pull);  // pull along the arc, left positive
    const double depth = offset_m - dot(n, pull);
    const double distance = norm(pull);
    const bool is_behind = dot(n, pull) < 0.0;
    if (std::abs(sideways) <= std::max(held_by_friction(friction, depth), rest_m) &&
        !(is_behind && friction == 0.0)) {
        return {};
    }
    ArcGoal goal;
    // Exactly behind the vertex both ways are equally good, so take the shorter one.
    if (std::abs(sideways) <= rest_m) {
        goal.turn = to_left_rad < to_right_rad ? 1.0 : -1.0;
    } else {
        goal.turn = sideways > 0.0 ? 1.0 : -1.0;
    }
    const double to_pull = std::abs(std::atan2(sideways, dot(n, pull)));
    const double to_edge = goal.turn > 0.0 ? to_left_rad : to_right_rad;
    double stop = to_pull;
    if (distance > offset_m) {
        stop = std::max(0.0, to_pull - std::acos(offset_m / distance));
        goal.end = ArcGoal::End::free;
    } else if (friction > 0.0) {
        stop = std::max(0.0, to_pull - angle_held_by_friction_rad(friction, offset_m, distance));
    }
    goal.angle_rad = stop;
    if (to_edge < stop) {
        goal.angle_rad = to_edge;
        goal.end = ArcGoal::End::edge;
    }
    return goal;
}

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

/// Handles a stop on the way: by a second contact, or by the budget with `left_m` to go.
ContactStep::Next ContactStep::arrive(const Sweep& sweep, double left_m) {
    if (!sweep.contact) {
        report_->carried_m = left_m;
        return Next::done;
    }
    // Seen from where the centre now lies, which on an arc is not quite where the sweep stopped.
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

/// At the end of the edge: goes round it if the outline turns away or ends, else goes on or holds.
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
    // An outline that runs back on itself turns away to neither side, so it is rounded like an end.
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
    // Not further off than it is: a change of level may have moved the edges nearer than the disc
    // is wide.
    const Position vertex = point_of(outlines_.segment(next), at_start ? 0.0 : 1.0);
    const double apart_m = dot(proxy_.centre - vertex, normal);
    const double offset_m = apart_m < at.offset_m - approach_tolerance_m
                                ? std::max(apart_m, contact_skin_m)
                                : at.offset_m;
    const Contact ahead{next, at_start ? 0.0 : 1.0, at.side, normal, offset_m, false};
    const double depth = -dot(handle_ - proxy_.centre, at.normal);
    if (dot(handle_ - proxy_.centre, away) > held_by_friction(settings_.friction, depth)) {
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
    if (dot(pull, at.normal) > at.offset_m) return let_go();
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
    // The chord passes nearer to the vertex than the arc, so the disc is made that much smaller;
    // otherwise other lines through the same vertex would stop it.
    const Arc arc{vertex, at.offset_m, std::min(radius_m_, at.offset_m)};
    const Position end = vertex + along<Position>(to, at.offset_m);
    const double chord_radius = arc.radius_m * std::cos(0.5 * step);
    Sweep found = sweep(end, chord_radius, {edge.segment, other.segment}, is_alone);
    const bool may_overlap = !is_alone && !found.is_cut && arc.radius_m - chord_radius > sunk_m;
    if (may_overlap && !found.contact) found.contact = too_near(end, arc.radius_m);
    at.normal =
        found.share >= 1.0 ? to : direction_of((1.0 - found.share) * from + found.share * to);
    if (found.contact) {
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
                // Not further off than it is, or it would move away from the handle.
                if (below.distance_m < at.offset_m - approach_tolerance_m) {
                    first().offset_m = below.distance_m;
                }
            }
            enter(ContactState::edge);
            place_at_contact();
            return Next::again;
        case ArcGoal::End::free:
            return let_go();
    }
    return Next::done;
}

/// Returns the angle from a round contact to the end of its arc, turning left or right, and the
/// edge found there.
double ContactStep::arc_to(const Contact& at, double turn, Contact& edge) {
    const bool at_end = at.parameter > 0.5;  // of its own segment
    // Seen from the left of the outline, the edge before a convex vertex lies to the left of the
    // vertex's normal and the edge after it to the right; from the right side it is the other way
    // round.
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
        return norm(pull) > 0.0 ? let_go() : Next::done;
    }
    double pull_a = 0.0;
    double pull_b = 0.0;
    const bool can_a = can_slide(a, b, pull_a);
    const bool can_b = can_slide(b, a, pull_b);
    if (!can_a && !can_b) return Next::done;
    // Takes the greater pull; if that has led back here, the other one.
    const bool wants_a = (pull_a >= pull_b) == (visits_ % 2 == 1);
    leave_corner(can_a && (!can_b || wants_a) ? 0 : 1);
    return Next::again;
}

/// Returns true if the handle pulls the proxy along one contact, pressed on it and away from the
/// other.
bool ContactStep::can_slide(const Contact& along_this, const Contact& other, double& pull_m) const {
    const Position pull = handle_ - proxy_.centre;
    const double depth = -dot(pull, along_this.normal);
    const double sideways = cross(along_this.normal, pull);
    pull_m = std::abs(sideways) - held_by_friction(settings_.friction, std::max(depth, 0.0));
    const Direction way = std::copysign(1.0, sideways) * left_of(along_this.normal);
    // Round an end, the way bends down at once, so it must not go into a line that it starts along.
    double least = -parallel;
    if (along_this.is_round) least = other.is_round ? -same_end : parallel;
    // Past an end almost at right angles to it, the way comes nearer to it only by rounding.
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

}  // namespace touchline
