#include "haptics/probe/clear_share.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchline {
namespace {

constexpr int most_advances = 24;
constexpr double never = std::numeric_limits<double>::infinity();
constexpr double near_enough_m = 1e-10;  // to the kept distance: the motion ends there

/// Returns the first moment at which room + rate t - bend t^2 / 2 falls to 0; infinity if it never
/// does.
double exhausted(double room, double rate, double bend) {
    if (room <= 0.0 && rate <= 0.0) return rate < 0.0 || bend > 0.0 ? 0.0 : never;
    const double root = std::sqrt(rate * rate + 2.0 * bend * room);
    if (rate < 0.0) return 2.0 * room / (root - rate);
    return bend > 0.0 ? (root + rate) / bend : never;
}

/// Returns whether exhausted() is `share` or later: a falling parabola is above its ends in
/// between.
bool lasts(double room, double rate, double bend, double share) {
    return room + share * (rate - 0.5 * bend * share) >= 0.0;
}

/// Returns whether free_beside_line() would find `share` or more. This settles most pairs, and
/// without a root.
bool is_free_beside_line(const Segment& edge, const Segment& line, Direction n, Position origin,
                         const ProbeMove& move, double keep_m, double share) {
    const double reach = std::max(dot(n, line.a), dot(n, line.b)) + keep_m;
    for (const Position end : {edge.a, edge.b}) {
        const Position arm = end - origin;
        const double rate = dot(n, move.by) + move.turn_rad * cross(arm, n);
        const double bend = move.turn_rad * move.turn_rad * norm(arm);
        if (!lasts(std::max(dot(n, end) - reach, 0.0), rate, bend, share)) return false;
    }
    return true;
}

/// Goes until the ends of the edge are too near along a fixed direction.
double free_beside_line(const Segment& edge, const Segment& line, Direction n, Position origin,
                        const ProbeMove& move, double keep_m) {
    const double reach = std::max(dot(n, line.a), dot(n, line.b)) + keep_m;
    double free = never;
    for (const Position end : {edge.a, edge.b}) {
        const Position arm = end - origin;
        const double rate = dot(n, move.by) + move.turn_rad * cross(arm, n);
        const double bend = move.turn_rad * move.turn_rad * norm(arm);
        free = std::min(free, exhausted(std::max(dot(n, end) - reach, 0.0), rate, bend));
    }
    return free;
}

/// Goes until the ends of the line are too near along a direction that turns with the edge.
double free_beside_edge(const Segment& edge, const Segment& line, Direction n, Position origin,
                        const ProbeMove& move, double keep_m) {
    const double reach = std::min(dot(n, edge.a), dot(n, edge.b)) - keep_m;
    const double way_m = norm(move.by);
    const double turn = std::abs(move.turn_rad);
    double free = never;
    for (const Position end : {line.a, line.b}) {
        const Position arm = end - origin;
        const double rate = dot(n, move.by) - move.turn_rad * dot(left_of(n), arm);
        const double bend = turn * (turn * (norm(arm) + way_m) + 2.0 * way_m);
        free = std::min(free, exhausted(std::max(reach - dot(n, end), 0.0), rate, bend));
    }
    return free;
}

}  // namespace

double clear_share(const EdgeAndLine& pair, const ProbePose& from, const ProbePlacement& start,
                   const ProbeMove& move, double keep_m, double most) {
    Separation at = pair.at;
    Segment edge = start(pair.edge);
    double share = 0.0;
    for (int i = 0; i < most_advances; ++i) {
        if (!(at.distance_m > 0.0)) return share;
        const Position origin = from.place() + share * move.by;
        const Direction n = at.normal;
        if (is_free_beside_line(edge, pair.line, n, origin, move, keep_m, most - share))
            return most;
        share += std::max(free_beside_line(edge, pair.line, n, origin, move, keep_m),
                          free_beside_edge(edge, pair.line, n, origin, move, keep_m));
        if (!(share < most)) return most;
        edge = ProbePlacement(from + share * move)(pair.edge);
        at = separation(edge, pair.line);
        if (at.distance_m - keep_m <= near_enough_m) return share;
    }
    return share;
}

}  // namespace touchline
