// How often a straight way crosses curves: on which side of a closed one a place is.
// Threads: pure functions.
#pragma once

#include "haptics/collision/tree_walk.h"

#include <optional>

namespace touchline {

/// Returns whether the way, moved to its right by less than any distance, passes through the
/// segment. So the ways and segments of a closed curve count consistently at vertices and along
/// segments.
[[nodiscard]] inline bool passes(Position from, Position to, const Segment& segment) {
    const Position a = segment.a;
    const Position b = segment.b;
    const bool is_a_left = orientation(from, to, a) >= 0;
    const bool is_b_left = orientation(from, to, b) >= 0;
    if (is_a_left == is_b_left) return false;
    const double lean = -dot(b - a, to - from);
    const auto is_left = [&](Position p) {
        const int side = orientation(a, b, p);
        return side != 0 ? side > 0 : lean >= 0.0;
    };
    return is_left(from) != is_left(to);
}

/// A visitor of TreeWalk.
class Crossings {
  public:
    static constexpr bool asks_leaf_boxes = false;

    Crossings(Position p, Position q) : p_(p), q_(q), way_{p, q - p, approach_tolerance_m} {}

    [[nodiscard]] Sifted sift(const Fan& fan) const { return touchline::sift(fan, way_); }

    [[nodiscard]] std::optional<double> near(const Box& box) const {
        if (!approach(box, way_).is_met) return {};
        return 0.0;
    }

    [[nodiscard]] static double cut() { return 1.0; }

    static bool spend(int /*boxes*/) { return true; }

    void leaf(SegmentRef /*ref*/, const Segment& segment) {
        count_ += passes(p_, q_, segment) ? 1 : 0;
    }

    [[nodiscard]] int count() const { return count_; }

  private:
    Position p_, q_;
    Way way_;
    int count_ = 0;
};

/// Counts how often the straight way from p to q crosses the curves as rendered at `level`. The
/// parity is right at vertices and along segments: for a closed curve the count is odd exactly if
/// one of p and q is inside (points on the curve count as on its upper side).
[[nodiscard]] inline int crossings(const CollisionTree& tree, const CurveSet& curves, Position p,
                                   Position q, double level) {
    Crossings visitor(p, q);
    (void)TreeWalk(tree, curves, level, visitor).run();
    return visitor.count();
}

}  // namespace touchline
