#include "tests/haptics/contact/step_rules.h"

#include "tests/exact/orientation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace touchline {
namespace {

constexpr double rounding_m = 1e-12;
constexpr double unfelt_m = 1e-9;  // a force of half a micronewton
constexpr double parallel = 1e-9;  // sine of an angle too small to tell

bool is_allowed(ContactState from, ContactState to) {
    return std::abs(static_cast<int>(from) - static_cast<int>(to)) == 1;
}

const char* broken_by_trail(const StepSeen& step) {
    const StateTrail& trail = step.report.transitions;
    if (trail[0] != step.before.state) return "the trail starts at the state before";
    for (int i = 1; i < trail.size(); ++i) {
        if (!is_allowed(trail[i - 1], trail[i])) return "only 0-1 and 1-2, both ways";
    }
    if (trail.size() < 16 && trail[trail.size() - 1] != step.report.state)
        return "the trail ends at the state after";
    if (step.after.state != step.report.state) return "the report's state is the proxy's";
    return nullptr;
}

const char* broken_by_motion(const StepSeen& step) {
    const Position from = step.before.centre;
    const Position to = step.after.centre;
    if (!is_finite(to) || !is_finite(step.report.force)) return "all numbers are finite";
    if (!(norm(step.handle - to) <= norm(step.handle - from) + rounding_m))
        return "the proxy never moves away from the handle";
    if (step.path.empty() || step.path.front() != from || step.path.back() != to)
        return "the way points lead from the old place to the new one";
    if (!step.judge.is_free(step.path)) return "no line is crossed";
    const double stiffness = step.settings.stiffness_N_per_m;
    if (step.report.force != along<Force>(to - step.handle, stiffness))
        return "the force is K (proxy - handle)";
    return nullptr;
}

Segment segment_of(const StepSeen& step, SegmentRef ref) {
    return step.curves.rendered_segment(ref.piece, step.level, ref.index);
}

/// Returns how far off a bend too slight for a sweep to detect puts a contact beyond it.
double bend_m(const Contact& at) {
    return std::sqrt(2.0 * approach_tolerance_m * at.offset_m);
}

const char* broken_by_contact(const StepSeen& step, std::size_t i) {
    const Contact& at = step.after.contacts[i];
    if (!(at.parameter >= 0.0 && at.parameter <= 1.0)) return "the parameter lies on the segment";
    const Segment s = segment_of(step, at.segment);
    const Position centre = point_of(s, at.parameter) + along<Position>(at.normal, at.offset_m);
    const double off_m = i == 0 ? 0.0 : bend_m(at);
    if (!(norm(centre - step.after.centre) <= rounding_m + off_m))
        return "the centre follows from the contact";
    if (at.is_round) {
        const bool is_end = at.parameter == 0.0 || at.parameter == 1.0;
        return is_end ? nullptr : "a round contact is at an end of its segment";
    }
    if (!(norm(at.normal - normal_of(s, at.side)) <= rounding_m))
        return "an edge's normal is its side's";
    const int side = exact::orientation(s.a, s.b, step.after.centre);
    if (side != static_cast<int>(at.side)) return "the centre lies on the contact's side";
    return nullptr;
}

/// Whether friction holds along the normal's tangent.
bool is_held_along(const StepSeen& step, const Contact& at) {
    const Position pull = step.handle - step.after.centre;
    const double depth_m = std::max(0.0, -dot(pull, at.normal));
    const double held_m = step.settings.friction * depth_m + unfelt_m + bend_m(at);
    return std::abs(cross(at.normal, pull)) <= held_m;
}

const char* broken_on_edge(const StepSeen& step) {
    const Contact& at = step.after.contacts[0];
    if (step.after.contact_count != 1 || at.is_round) return "an edge is one contact, not round";
    if (step.report.carried_m > 0.0) return nullptr;
    const double depth_m = -dot(step.handle - step.after.centre, at.normal);
    if (!(depth_m >= -rounding_m)) return "an edge holds only what presses on it";
    return is_held_along(step, at) ? nullptr : "along an edge only friction holds";
}

/// Whether the normal lies between those of the two edges at the vertex, or in the half circle
/// round an end.
bool is_on_arc(const StepSeen& step, const Contact& at) {
    const bool at_end = at.parameter > 0.5;
    const Segment s = segment_of(step, at.segment);
    const Direction outward = (at_end ? 1.0 : -1.0) * direction_of(s.b - s.a);
    const SegmentRef over = at_end ? step.curves.next(at.segment, step.level)
                                   : step.curves.previous(at.segment, step.level);
    // A touch of the vertex and one of the edge beside it count as the same moment while the edge
    // is nearer by at most the tolerance.
    const double least = -std::sqrt(4.0 * approach_tolerance_m / at.offset_m);
    if (dot(at.normal, outward) < least) return false;
    if (over.piece < 0) return true;
    const Segment beside = segment_of(step, over);
    return dot(at.normal, (at_end ? -1.0 : 1.0) * direction_of(beside.b - beside.a)) >= least;
}

const char* broken_on_arc(const StepSeen& step) {
    const Contact& at = step.after.contacts[0];
    if (!at.is_round) return "a vertex of one contact is round";
    // A disc that keeps less from another line may touch the vertex from beside its arc.
    const double kept_m = step.judge.distance_m(step.after.centre, at.offset_m);
    const bool is_nearest = kept_m > at.offset_m - approach_tolerance_m;
    if (is_nearest && !is_on_arc(step, at))
        return "a round contact's normal lies between its edges'";
    if (step.report.carried_m > 0.0) return nullptr;
    if (dot(step.handle - step.after.centre, at.normal) > rounding_m)
        return "a vertex holds only what presses on it";
    return is_held_along(step, at) ? nullptr : "round a vertex only friction holds";
}

/// Whether the contacts' normals, with friction the sides of their cones, positively span the
/// force: every way towards the handle runs into one of them.
bool is_spanned(const StepSeen& step) {
    const Position pull = step.handle - step.after.centre;
    const double lean = step.settings.friction;
    std::array<Direction, 4> sides;
    for (std::size_t i = 0; i < 2; ++i) {
        const Direction n = step.after.contacts[i].normal;
        sides[2 * i] = direction_of(n + lean * left_of(n));
        sides[2 * i + 1] = direction_of(n + -lean * left_of(n));
    }
    const auto is_open = [&](Direction way) {
        return std::all_of(sides.begin(), sides.end(),
                           [&](Direction n) { return dot(way, n) >= -parallel; });
    };
    const auto is_way_out = [&](Direction way) {
        return is_open(way) && dot(way, pull) > unfelt_m;
    };
    return !is_way_out(direction_of(pull)) &&
           std::none_of(sides.begin(), sides.end(), [&](Direction n) {
               return is_way_out(left_of(n)) || is_way_out(-left_of(n));
           });
}

const char* broken_at_vertex(const StepSeen& step) {
    if (step.after.contact_count == 1) return broken_on_arc(step);
    if (step.after.contact_count != 2) return "a vertex is one contact or two";
    if (step.report.carried_m > 0.0 || is_spanned(step)) return nullptr;
    return "two contacts hold only a force that their normals span";
}

const char* broken_by_state(const StepSeen& step) {
    if (step.report.state == ContactState::free) {
        if (step.after.contact_count != 0) return "free is without a contact";
        const bool is_there = step.after.centre == step.handle;
        return is_there || step.report.carried_m > 0.0 ? nullptr : "free is without a force";
    }
    const auto count = static_cast<std::size_t>(step.after.contact_count);
    for (std::size_t i = 0; i < std::min(count, step.after.contacts.size()); ++i) {
        if (const char* broken = broken_by_contact(step, i)) return broken;
    }
    return step.report.state == ContactState::edge ? broken_on_edge(step) : broken_at_vertex(step);
}

}  // namespace

const char* broken_rule_of_motion(const StepSeen& step) {
    if (const char* broken = broken_by_motion(step)) return broken;
    return broken_by_trail(step);
}

const char* broken_rule(const StepSeen& step) {
    if (const char* broken = broken_rule_of_motion(step)) return broken;
    return broken_by_state(step);
}

}  // namespace touchline
