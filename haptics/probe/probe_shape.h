// A rigid shape in the hand: straight edges as thin as the lines of a scene, rounded by a radius,
// with a small tree over them; where it is and how it moves; and how two straight stretches lie to
// each other, the bound and the leaf test of a shape against the scene's tree. Threads: values and
// pure functions; a shape is immutable once built, and any thread may read it.
#pragma once

#include "config/types/hand_state.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"
#include "config/types/vec2.h"
#include "haptics/collision/box.h"
#include "haptics/collision/lanes.h"
#include "haptics/curve/segment.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace touchline {

/// Everything within `thickness_m` of the chord.
struct Capsule {
    Segment chord;
    double thickness_m = 0.0;
};

/// Returns a capsule that holds the box; its chord runs along the longer side.
[[nodiscard]] inline Capsule capsule_of(const Box& box) {
    const double along_m = box.along_high - box.along_low;
    const double across_m = box.across_high - box.across_low;
    const double length = norm(box.axis);
    const Position across = left_of(box.axis);
    if (along_m >= across_m) {
        const Position middle = box.origin + 0.5 * (box.across_low + box.across_high) * across;
        return {{middle + box.along_low * box.axis, middle + box.along_high * box.axis},
                0.5 * across_m * length};
    }
    const Position middle = box.origin + 0.5 * (box.along_low + box.along_high) * box.axis;
    return {{middle + box.across_low * across, middle + box.across_high * across},
            0.5 * along_m * length};
}

/// Returns the point at a share along a segment; beyond its ends, exactly the end.
[[nodiscard]] inline Position point_at(const Segment& s, double share) {
    if (share >= 1.0) return s.b;
    return s.a + std::max(share, 0.0) * (s.b - s.a);
}

/// The nearest points of two segments.
struct Separation {
    double distance_m = 0.0;
    Direction normal;   // from the second to the first; {0, 0} where they meet
    Position on_first;  // the points nearest to each other
    Position on_second;
};

/// One end is always among the nearest points of segments that do not cross: finds which by what
/// is cheap, two ends at a time, then the points. About 60 operations and a root, one branch.
[[nodiscard]] [[gnu::always_inline]] inline Separation separation(const Segment& first,
                                                                  const Segment& second) {
    using lanes::Pair;
    const Position e = first.b - first.a;
    const Position f = second.b - second.a;
    const Position w = second.a - first.a;
    const double ee = dot(e, e);
    const double ff = dot(f, f);
    const double ew = dot(e, w);
    const double fw = dot(f, w);
    const double ef = dot(e, f);
    const double turn = cross(e, f);
    const double s = cross(w, f);  // of the lines' common point, times `turn`
    const double t = cross(w, e);
    const double size = turn * turn;
    const bool do_cross = (turn != 0.0) & (s * turn >= 0.0) & (s * turn <= size) &
                          (t * turn >= 0.0) & (t * turn <= size);
    // The ends of the first in the lower lanes, those of the second in the upper ones.
    constexpr Pair none{0.0, 0.0};
    constexpr Pair one{1.0, 1.0};
    const Pair sizes{ff, ee};
    const Pair per = sizes > none ? one / sizes : none;
    const auto share = [&](Pair x) { return x > none ? (x < one ? x : one) : none; };
    const Pair of_a = share(Pair{-fw, ew} * per);
    const Pair of_b = share(Pair{ef - fw, ew + ef} * per);
    const Pair along_x{f.x, -e.x};
    const Pair along_y{f.y, -e.y};
    const Pair a_x = w.x + of_a * along_x;
    const Pair a_y = w.y + of_a * along_y;
    const Pair b_x = Pair{w.x - e.x, w.x + f.x} + of_b * along_x;
    const Pair b_y = Pair{w.y - e.y, w.y + f.y} + of_b * along_y;
    const Pair a = a_x * a_x + a_y * a_y;
    const Pair b = b_x * b_x + b_y * b_y;
    const auto is_nearer = a <= b;
    const Pair x = is_nearer ? a_x : b_x;
    const Pair y = is_nearer ? a_y : b_y;
    const Pair square = is_nearer ? a : b;
    const Pair of = is_nearer ? of_a : of_b;
    const bool is_first = square[0] <= square[1];
    const double distance_m = std::sqrt(is_first ? square[0] : square[1]);
    const Position by = is_first ? Position{-x[0], -y[0]} : Position{-x[1], -y[1]};
    Separation best;
    if (is_first) {
        best.on_first = is_nearer[0] != 0 ? first.a : first.b;
        best.on_second = point_at(second, of[0]);
    } else {
        best.on_first = point_at(first, of[1]);
        best.on_second = is_nearer[1] != 0 ? second.a : second.b;
    }
    if (do_cross) return {0.0, {0.0, 0.0}, best.on_first, best.on_first};
    best.distance_m = distance_m;
    const double per_distance = distance_m > 0.0 ? 1.0 / distance_m : 0.0;
    best.normal = along<Direction>(by, per_distance);
    return best;
}

/// The place of a shape's origin in W, and its turn, counter-clockwise; full turns count.
struct ProbePose {
    double x_m = 0.0;
    double y_m = 0.0;
    double angle_rad = 0.0;

    [[nodiscard]] Position place() const { return {x_m, y_m}; }

    friend bool operator==(const ProbePose&, const ProbePose&) = default;
};

[[nodiscard]] inline bool is_finite(const ProbePose& pose) {
    return std::isfinite(pose.x_m) && std::isfinite(pose.y_m) && std::isfinite(pose.angle_rad);
}

/// The cosine and the sine of an angle.
class Rotation {
  public:
    Rotation() = default;

    /// A single move turns little: there a series is right to 2e-16, for less than a call.
    explicit Rotation(double angle_rad) {
        constexpr double small_rad = 0.125;
        const double square = angle_rad * angle_rad;
        if (!(std::abs(angle_rad) <= small_rad)) {
            cos_ = std::cos(angle_rad);
            sin_ = std::sin(angle_rad);
            return;
        }
        const auto one_less = [square](double part, double rest) {
            return 1.0 - part * square * rest;
        };
        cos_ = one_less(
            1.0 / 2,
            one_less(1.0 / 12, one_less(1.0 / 30, one_less(1.0 / 56, one_less(1.0 / 90, 1.0)))));
        sin_ = angle_rad *
               one_less(1.0 / 6,
                        one_less(1.0 / 20,
                                 one_less(1.0 / 42, one_less(1.0 / 72, one_less(1.0 / 110, 1.0)))));
    }

    template <class Unit>
    [[nodiscard]] Vec2<Unit> operator()(Vec2<Unit> v) const {
        return {cos_ * v.x - sin_ * v.y, sin_ * v.x + cos_ * v.y};
    }

    /// The other way round.
    template <class Unit>
    [[nodiscard]] Vec2<Unit> back(Vec2<Unit> v) const {
        return {cos_ * v.x + sin_ * v.y, cos_ * v.y - sin_ * v.x};
    }

    /// Both, one after the other.
    [[nodiscard]] Rotation operator*(const Rotation& other) const {
        Rotation both;
        both.cos_ = cos_ * other.cos_ - sin_ * other.sin_;
        both.sin_ = sin_ * other.cos_ + cos_ * other.sin_;
        return both;
    }

  private:
    double cos_ = 1.0, sin_ = 0.0;
};

/// A move that turns at a steady rate while one point of the shape, the pivot, goes straight.
struct ProbeMove {
    Position by;  // of the pivot
    double turn_rad = 0.0;
    Position pivot{};  // from the origin, at the start

    /// How the origin sets out.
    [[nodiscard]] Position origin_by() const {
        return {by.x + turn_rad * pivot.y, by.y - turn_rad * pivot.x};
    }

    /// How much further a point within `r_max_m` of the origin may come than it set out to.
    [[nodiscard]] double bend_m(double r_max_m) const {
        return 0.5 * turn_rad * turn_rad * (r_max_m + norm(pivot));
    }

    /// No point within `r_max_m` of the origin moves further than this.
    [[nodiscard]] double reach_m(double r_max_m) const {
        if (pivot == Position{}) return norm(by) + std::abs(turn_rad) * r_max_m;
        return norm(origin_by()) + std::abs(turn_rad) * r_max_m + bend_m(r_max_m);
    }
};

[[nodiscard]] inline ProbeMove operator*(double share, const ProbeMove& move) {
    return {share * move.by, share * move.turn_rad, move.pivot};
}

[[nodiscard]] inline ProbePose operator+(const ProbePose& pose, const ProbeMove& move) {
    Position by = move.by;
    if (move.pivot != Position{}) by = by + move.pivot - Rotation(move.turn_rad)(move.pivot);
    return {pose.x_m + by.x, pose.y_m + by.y, pose.angle_rad + move.turn_rad};
}

/// The move from `from` to `to`.
[[nodiscard]] inline ProbeMove operator-(const ProbePose& to, const ProbePose& from) {
    return {to.place() - from.place(), to.angle_rad - from.angle_rad, {}};
}

/// Adds poses of a move from `from` on, in order, the last at its end. A shape that goes straight
/// and turns steadily from `from` to each in turn is within 1 nm of the move at every moment. Their
/// number grows with the turn. Allocates.
void add_way(const ProbePose& from, const ProbeMove& move, std::vector<ProbePose>& way);

/// A pose with its sine and cosine worked out.
class ProbePlacement {
  public:
    /// The pose lies at the origin of W and is not turned.
    ProbePlacement() = default;

    explicit ProbePlacement(const ProbePose& pose) : origin_(pose.place()), turn_(pose.angle_rad) {}

    /// Returns the placement after a move from this one, to 1e-16 of the shape's size.
    [[nodiscard]] ProbePlacement after(const ProbeMove& move) const {
        const Rotation turn(move.turn_rad);
        ProbePlacement moved;
        moved.origin_ = origin_ + move.by + (move.pivot - turn(move.pivot));
        moved.turn_ = turn * turn_;
        return moved;
    }

    /// Maps a point from the shape's frame to W.
    [[nodiscard]] Position operator()(Position p) const { return origin_ + turn_(p); }

    [[nodiscard]] Segment operator()(const Segment& s) const {
        return {(*this)(s.a), (*this)(s.b)};
    }

    [[nodiscard]] Position origin() const { return origin_; }

    /// Turns a vector of W into the shape's frame.
    template <class Unit>
    [[nodiscard]] Vec2<Unit> seen_by_shape(Vec2<Unit> v) const {
        return turn_.back(v);
    }

  private:
    Position origin_;
    Rotation turn_;
};

inline constexpr std::size_t most_probe_edges = 4096;
inline constexpr double largest_probe_m = 0.1;  // of a point from the origin

/// A part of a shape's edges, inside a capsule in the shape's frame.
struct ProbeNode {
    Capsule capsule;
    std::int32_t left = -1;  // child; the right one is left + 1. -1: a leaf
    std::int32_t edge = -1;  // of a leaf
};

class ProbeShape {
  public:
    /// Takes edges and radius in metres, about the point that the hand holds. Fails, with a line
    /// that says why, if there is no edge, more than 4096 edges, a point that is not finite or
    /// further than 0.1 m from the origin, or a radius outside 0 ... 0.02 m.
    [[nodiscard]] static Result<ProbeShape> build(std::vector<Segment> edges, double radius_m);

    /// Makes a shape of all outlines of a map; the hand holds the middle of the drawing area.
    [[nodiscard]] static Result<ProbeShape> of_map(const TactileMap& map, double radius_m);

    [[nodiscard]] std::span<const Segment> edges() const { return edges_; }

    /// The tree's nodes; the first is the root.
    [[nodiscard]] std::span<const ProbeNode> nodes() const { return nodes_; }

    /// The rounding radius of every edge.
    [[nodiscard]] double radius_m() const { return radius_m_; }

    /// The largest distance of a point of the edges from the origin.
    [[nodiscard]] double r_max_m() const { return r_max_m_; }

  private:
    void split(std::size_t node, std::size_t first, std::size_t last);

    std::vector<Segment> edges_;
    std::vector<ProbeNode> nodes_;
    double radius_m_ = 0.0;
    double r_max_m_ = 0.0;
};

/// Ready shapes, in metres, as polylines like any other outline.
namespace probes {

/// A point with a radius. It is round, so it feels no torque.
[[nodiscard]] ProbeShape disc(double radius_m);

/// A rectangle about its centre.
[[nodiscard]] Outline bar(double length_m, double width_m);

/// Two legs of equal width, with their outer corner at the origin.
[[nodiscard]] Outline ell(double leg_m, double width_m);

/// A bow (a polygon), a shank to the right, and a bit with two teeth at its end; the bow is at the
/// origin.
[[nodiscard]] Outline key(double length_m);

/// The edges of an outline.
[[nodiscard]] std::vector<Segment> edges_of(const Outline& outline);

}  // namespace probes

/// Builds a shape as large as a thumb, so that it can turn among the outlines of a picture; none
/// gives a point. Allocates.
[[nodiscard]] ProbeShape held_shape(HeldShape shape);

}  // namespace touchline
