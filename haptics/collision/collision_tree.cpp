#include "haptics/collision/collision_tree.h"

#include "config/types/steady_clock.h"
#include "haptics/collision/crossing.h"
#include "haptics/collision/tree_walk.h"

#include <cmath>

namespace touchline {
namespace {

/// Keys are distances, rounded down.
Sifted distances(const Fan& fan, Position p) {
    Sifted out{(1U << Fan::width) - 1U, {}, 0.0F};
    for (std::size_t k = 0; k < Fan::width; ++k) {
        const auto distance = static_cast<float>(distance_m(fan.box(k), p));
        out.key[k] = distance > 0.0F ? std::nextafterf(distance, 0.0F) : 0.0F;
    }
    return out;
}

/// Counts boxes; looks at the clock only where a deadline is set.
class Spender {
  public:
    explicit Spender(const Budget& budget) : budget_(budget) {}

    bool spend(int boxes) {
        if (opened_ + boxes > budget_.boxes) return false;
        if (budget_.deadline_ns != 0 && steady_now_ns() >= budget_.deadline_ns) return false;
        opened_ += boxes;
        return true;
    }

    [[nodiscard]] int opened() const { return opened_; }

  private:
    Budget budget_;
    int opened_ = 0;
};

/// Collects the first of several touches, ties to the lowest segment.
class FirstTouch {
  public:
    explicit FirstTouch(const Motion& motion)
        : motion_(motion), way_(way_of(motion)), tie_(tie_of(motion)) {}

    [[nodiscard]] const Way& way() const { return way_; }

    /// What is not looked at stays at least this far out of reach.
    void spare(double margin_m) { least_gap2_m2_ = std::min(least_gap2_m2_, margin_m * margin_m); }

    Sifted sift(const Fan& fan) {
        const Sifted found = touchline::sift(fan, way_);
        least_gap2_m2_ = std::min(least_gap2_m2_, static_cast<double>(found.gap2_m2));
        return found;
    }

    /// The share of the way at which a box is entered; nothing where it cannot matter.
    [[nodiscard]] std::optional<double> near(const Box& box) {
        const Approach found = approach(box, way_);
        if (found.is_met) return found.entry;
        least_gap2_m2_ = std::min(least_gap2_m2_, found.gap2_m2);
        return {};
    }

    [[nodiscard]] double cut() const { return hit_.is_hit ? hit_.clear + tie_ : 1.0; }

    void test(SegmentRef ref, const Segment& segment) {
        if (ref == motion_.excluded[0] || ref == motion_.excluded[1]) return;
        least_gap2_m2_ = 0.0;
        const auto found = touch(motion_.from, motion_.to, motion_.radius_m, segment);
        if (!found) return;
        if (hit_.is_hit && found->fraction > hit_.clear + tie_) return;
        const bool is_tie = hit_.is_hit && found->fraction >= hit_.clear - tie_;
        const bool is_kept = is_tie && hit_.segment < ref;
        const double clear = is_tie ? std::min(hit_.clear, found->fraction) : found->fraction;
        if (!is_kept) hit_ = {true, clear, ref, *found, 0};
        hit_.clear = clear;
    }

    /// `unopened`: the earliest moment at which a box left unopened is met. A hit counts only
    /// before it.
    [[nodiscard]] Hit result(double unopened, int opened) {
        if (unopened <= cut()) {
            const double clear = std::min(unopened, hit_.is_hit ? hit_.clear : 1.0);
            hit_ = {};
            hit_.clear = clear;
        } else if (!hit_.is_hit) {
            hit_.spare_m = std::sqrt(least_gap2_m2_);
        }
        hit_.boxes = opened;
        return hit_;
    }

  private:
    /// The tolerance is more than all rounding: no box is entered after what it holds is touched.
    static Way way_of(const Motion& motion) {
        return {motion.from, motion.to - motion.from, motion.radius_m + approach_tolerance_m};
    }

    /// Share of the motion within which two contacts are one moment.
    static double tie_of(const Motion& motion) {
        constexpr double few_ulp = 8.9e-16;
        if (motion.radius_m == 0.0) return few_ulp;
        return approach_tolerance_m / std::max(norm(motion.to - motion.from), 1e-30);
    }

    const Motion& motion_;
    Way way_;
    double tie_;
    double least_gap2_m2_ = INFINITY;
    Hit hit_;
};

class FirstHit {
  public:
    static constexpr bool asks_leaf_boxes = false;

    FirstHit(const Motion& motion, const Budget& budget) : first_(motion), spender_(budget) {}

    [[nodiscard]] const Way& way() const { return first_.way(); }

    void spare(double margin_m) { first_.spare(margin_m); }

    Sifted sift(const Fan& fan) { return first_.sift(fan); }

    [[nodiscard]] std::optional<double> near(const Box& box) { return first_.near(box); }

    [[nodiscard]] double cut() const { return first_.cut(); }

    bool spend(int boxes) { return spender_.spend(boxes); }

    void leaf(SegmentRef ref, const Segment& segment) { first_.test(ref, segment); }

    Hit result(double unopened) { return first_.result(unopened, spender_.opened()); }

  private:
    FirstTouch first_;
    Spender spender_;
};

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

class ClosestPoint {
  public:
    static constexpr bool asks_leaf_boxes = false;

    ClosestPoint(Position p, double within_m, const Budget& budget) : p_(p), spender_(budget) {
        closest_.distance_m = within_m;
    }

    [[nodiscard]] Sifted sift(const Fan& fan) const { return distances(fan, p_); }

    [[nodiscard]] std::optional<double> near(const Box& box) const { return distance_m(box, p_); }

    [[nodiscard]] double cut() const { return closest_.distance_m; }

    bool spend(int boxes) { return spender_.spend(boxes); }

    void leaf(SegmentRef ref, const Segment& segment) {
        const Foot at = foot(p_, segment);
        const bool is_nearer = at.distance_m < closest_.distance_m;
        const bool is_lower = at.distance_m == closest_.distance_m && closest_.segment.piece >= 0 &&
                              ref < closest_.segment;
        if (!is_nearer && !is_lower) return;
        closest_ = {ref, at.parameter, at.point, at.distance_m, 0, true};
    }

    /// `unopened`: the distance of the nearest box left unopened.
    Closest result(double unopened) {
        closest_.boxes = spender_.opened();
        closest_.is_complete = unopened > closest_.distance_m;
        return closest_;
    }

  private:
    Position p_;
    Spender spender_;
    Closest closest_;
};

/// Stops at the first leaf's box within reach.
class AnyNear {
  public:
    static constexpr bool asks_leaf_boxes = true;

    AnyNear(Position p, double reach_m, const Budget& budget)
        : p_(p), reach_m_(reach_m), spender_(budget) {}

    [[nodiscard]] Sifted sift(const Fan& fan) const { return distances(fan, p_); }

    [[nodiscard]] std::optional<double> near(const Box& box) const { return distance_m(box, p_); }

    [[nodiscard]] double cut() const { return is_met_ ? -1.0 : reach_m_; }

    bool spend(int boxes) { return spender_.spend(boxes); }

    void leaf(SegmentRef /*ref*/, const Segment& /*segment*/) { is_met_ = true; }

    [[nodiscard]] Clearance result(double unopened) const {
        return {!is_met_ && unopened > reach_m_, spender_.opened()};
    }

  private:
    Position p_;
    double reach_m_;
    Spender spender_;
    bool is_met_ = false;
};

}  // namespace

Hit CollisionTree::first_hit(const CurveSet& curves, const Motion& motion,
                             const Budget& budget) const {
    FirstHit visitor(motion, budget);
    TreeWalk walk(*this, curves, motion.level, visitor);
    const auto cells = start_grid_.cells_near(visitor.way());
    if (!cells) return visitor.result(walk.run());
    visitor.spare(cells->margin_m);
    return visitor.result(walk.run_from(*cells));
}

int CollisionTree::crossings(const CurveSet& curves, Position p, Position q, double level) const {
    Crossings visitor(p, q);
    (void)TreeWalk(*this, curves, level, visitor).run();
    return visitor.count();
}

Closest CollisionTree::closest_point(const CurveSet& curves, Position p, double level,
                                     double within_m, const Budget& budget) const {
    ClosestPoint visitor(p, within_m, budget);
    const double unopened = TreeWalk(*this, curves, level, visitor).run();
    return visitor.result(unopened);
}

Clearance CollisionTree::clearance(const CurveSet& curves, Position p, double distance_m,
                                   double level, const Budget& budget) const {
    AnyNear visitor(p, distance_m, budget);
    const double unopened = TreeWalk(*this, curves, level, visitor).run();
    return visitor.result(unopened);
}

NodeRange CollisionTree::nodes(const CurveSet& curves, int piece, double level) {
    const double rendered = curves.rendered_level(piece, level);
    const auto leaf = static_cast<int>(std::ceil(rendered));
    return {curves.first_point(piece, leaf), rendered < leaf};
}

ErrorBox CollisionTree::box(const CurveSet& curves, int piece, int level, int j) const {
    return {corners_of(node_box(curves, {piece, level, j})), piece, level, j};
}

std::size_t CollisionTree::memory_bytes() const {
    return extents_.capacity() * sizeof(PackedExtents) + alone_.capacity() / 8 +
           bounds_.capacity() * sizeof(Bound) + roots_.capacity() * sizeof(Stretch) +
           start_grid_.memory_bytes();
}

void CollisionTree::boundary_section(const CurveSet& curves, Position handle, int level,
                                     std::vector<ErrorBox>& section) const {
    std::vector<Node> open;
    for (const Stretch& roots : roots_) {
        for (int k = 0; k < roots.count; ++k) {
            open.push_back({roots.piece, roots.level, roots.first + k});
        }
    }
    while (!open.empty()) {
        const Node node = open.back();
        open.pop_back();
        const bool holds = distance_m(node_box(curves, node), handle) <= 0.0;
        if (!holds || node.level <= level || node.level == 0) {
            section.push_back(box(curves, node.piece, node.level, node.index));
            continue;
        }
        if (2 * node.index + 1 < curves.segment_count(node.piece, node.level - 1)) {
            open.push_back({node.piece, node.level - 1, 2 * node.index + 1});
        }
        open.push_back({node.piece, node.level - 1, 2 * node.index});
    }
}

}  // namespace touchline
