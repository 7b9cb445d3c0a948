// How far a turning edge may go beside a line: conservative advancement along directions.
#include "haptics/probe/probe_front.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchline {
namespace {

constexpr int most_advances = 24;
constexpr double never = std::numeric_limits<double>::infinity();
constexpr double near_enough_m = 1e-10;  // to the kept distance: the motion ends there

/// How the room beside an end goes on over a move: room + rate t - bend t^2 / 2.
struct Falling {
    double room, rate, bend;
};

/// A motion from a moment on: the pivot's place, its move, and the share of the move that is left.
struct MotionLeft {
    Position pivot;
    const ProbeMove& move;
    double left;
};

/// The room of an edge's end beyond `reach` along a fixed direction. The end turns about the pivot,
/// so it speeds up towards it: by what points along the direction now, and what turns into it.
[[gnu::always_inline]] inline Falling falling(Position end, double reach, Direction n,
                                              const MotionLeft& motion) {
    const double turn = motion.move.turn_rad;
    const Position arm = end - motion.pivot;
    const double size = norm(arm);
    const double along = std::max(dot(n, arm), 0.0) + std::abs(turn) * motion.left * size;
    return {std::max(dot(n, end) - reach, 0.0), dot(n, motion.move.by) + turn * cross(arm, n),
            turn * turn * std::min(along, size)};
}

/// Returns the first moment at which the room falls to 0; infinity if it never does.
[[gnu::always_inline]] inline double exhausted(const Falling& f) {
    if (f.room <= 0.0 && f.rate <= 0.0) return f.rate < 0.0 || f.bend > 0.0 ? 0.0 : never;
    const double root = std::sqrt(f.rate * f.rate + 2.0 * f.bend * f.room);
    if (f.rate < 0.0) return 2.0 * f.room / (root - f.rate);
    return f.bend > 0.0 ? (root + f.rate) / f.bend : never;
}

/// Returns whether exhausted() is `share` or later: a falling parabola is above its ends in
/// between.
[[gnu::always_inline]] inline bool lasts(const Falling& f, double share) {
    return f.room + share * (f.rate - 0.5 * f.bend * share) >= 0.0;
}

/// Returns the share over which the ends of the edge are not too near along a fixed direction;
/// infinity if that is all that is left. Most pairs are settled so, without a root.
[[gnu::always_inline]] inline double free_beside_line(const Segment& edge, const Segment& line,
                                                      Direction n, const MotionLeft& motion,
                                                      double keep_m) {
    const double reach = std::max(dot(n, line.a), dot(n, line.b)) + keep_m;
    const Falling a = falling(edge.a, reach, n, motion);
    const Falling b = falling(edge.b, reach, n, motion);
    if (lasts(a, motion.left) && lasts(b, motion.left)) return never;
    return std::min(exhausted(a), exhausted(b));
}

/// Goes until the ends of the line are too near along a direction that turns with the edge.
[[gnu::always_inline]] inline double free_beside_edge(const Segment& edge, const Segment& line,
                                                      Direction n, const MotionLeft& motion,
                                                      double keep_m) {
    const double reach = std::min(dot(n, edge.a), dot(n, edge.b)) - keep_m;
    const Position by = motion.move.by;
    const double turn = motion.move.turn_rad;
    const double way_m = norm(by);
    double free = never;
    for (const Position end : {line.a, line.b}) {
        const Position arm = end - motion.pivot;
        const double rate = dot(n, by) - turn * dot(left_of(n), arm);
        const double bend = -turn * (turn * dot(n, arm) + 2.0 * dot(left_of(n), by));
        const double more =
            turn * turn * (std::abs(turn) * (norm(arm) + way_m) + 3.0 * way_m) * motion.left;
        free = std::min(free, exhausted({std::max(reach - dot(n, end), 0.0), rate,
                                         std::max(bend, 0.0) + more}));
    }
    return free;
}

}  // namespace

double clear_share(const EdgeAndLine& pair, const ProbePlacement& start, const ProbeMove& move,
                   double keep_m, double most) {
    Separation at = pair.at;
    Segment edge = start(pair.edge);
    double share = 0.0;
    for (int i = 0; i < most_advances; ++i) {
        if (!(at.distance_m > 0.0)) return share;
        const MotionLeft motion{start.origin() + move.pivot + share * move.by, move, most - share};
        const Direction n = at.normal;
        const double beside_line = free_beside_line(edge, pair.line, n, motion, keep_m);
        if (beside_line == never) return most;
        const double next =
            share + std::max(beside_line, free_beside_edge(edge, pair.line, n, motion, keep_m));
        if (next >= most) return most;
        if (!(next > share)) return share;
        share = next;
        edge = start.after(share * move)(pair.edge);
        at = separation(edge, pair.line);
        if (at.distance_m - keep_m <= near_enough_m) return share;
    }
    return share;
}

}  // namespace touchline
