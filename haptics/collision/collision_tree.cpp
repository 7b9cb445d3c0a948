#include "haptics/collision/collision_tree.h"

#include "haptics/collision/frame.h"
#include "haptics/collision/tree_walk.h"

#include <chrono>
#include <cmath>

namespace touchline {
namespace {

std::int64_t steady_ns() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// Counts boxes; looks at the clock only where a deadline is set.
class Spender {
  public:
    explicit Spender(const Budget& budget) : budget_(budget) {}

    bool spend() {
        if (opened_ >= budget_.boxes) return false;
        if (budget_.deadline_ns != 0 && steady_ns() >= budget_.deadline_ns) return false;
        ++opened_;
        return true;
    }

    [[nodiscard]] int opened() const { return opened_; }

  private:
    Budget budget_;
    int opened_ = 0;
};

class FirstHit {
  public:
    FirstHit(const CurveSet& curves, const Motion& motion, const Budget& budget)
        : curves_(curves),
          motion_(motion),
          spender_(budget),
          tie_(approach_tolerance_m / std::max(norm(motion.to - motion.from), 1e-30)) {}

    std::optional<double> near(const AlignedBox& box) const {
        // The tolerance is more than all rounding: no box is entered after what it holds is
        // touched.
        return entry(grown(box, motion_.radius_m + approach_tolerance_m), motion_.from, motion_.to);
    }

    [[nodiscard]] double cut() const { return hit_.is_hit ? hit_.clear + tie_ : 1.0; }

    bool spend() { return spender_.spend(); }

    void leaf(SegmentRef ref) {
        if (ref == motion_.excluded[0] || ref == motion_.excluded[1]) return;
        const auto found = touch(motion_.from, motion_.to, motion_.radius_m,
                                 curves_.rendered_segment(ref.piece, motion_.level, ref.index));
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
    Hit result(double unopened) {
        if (unopened <= cut()) {
            const double clear = std::min(unopened, hit_.is_hit ? hit_.clear : 1.0);
            hit_ = {};
            hit_.clear = clear;
        }
        hit_.boxes = spender_.opened();
        return hit_;
    }

  private:
    const CurveSet& curves_;
    const Motion& motion_;
    Spender spender_;
    double tie_;  // share of the motion within which two contacts are one moment
    Hit hit_;
};

class ClosestPoint {
  public:
    ClosestPoint(const CurveSet& curves, Position p, double level, double within_m,
                 const Budget& budget)
        : curves_(curves), p_(p), level_(level), spender_(budget) {
        closest_.distance_m = within_m;
    }

    std::optional<double> near(const AlignedBox& box) const { return distance_m(box, p_); }

    [[nodiscard]] double cut() const { return closest_.distance_m; }

    bool spend() { return spender_.spend(); }

    void leaf(SegmentRef ref) {
        const Foot at = foot(p_, curves_.rendered_segment(ref.piece, level_, ref.index));
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
    const CurveSet& curves_;
    Position p_;
    double level_;
    Spender spender_;
    Closest closest_;
};

/// Stops at the first leaf within reach.
class AnyNear {
  public:
    AnyNear(Position p, double reach_m, const Budget& budget)
        : p_(p), reach_m_(reach_m), spender_(budget) {}

    std::optional<double> near(const AlignedBox& box) const { return distance_m(box, p_); }

    [[nodiscard]] double cut() const { return is_met_ ? -1.0 : reach_m_; }

    bool spend() { return spender_.spend(); }

    void leaf(SegmentRef /*ref*/) { is_met_ = true; }

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

std::size_t CollisionTree::box_index(const Node& node) const {
    return first_box_[first_level_[static_cast<std::size_t>(node.piece)] +
                      static_cast<std::uint32_t>(node.level)] +
           static_cast<std::size_t>(node.index);
}

int CollisionTree::leaf_level(const CurveSet& curves, int piece, double level) {
    return static_cast<int>(std::ceil(curves.rendered_level(piece, level)));
}

AlignedBox CollisionTree::aligned_box(const CurveSet& curves, const Node& node) const {
    const Extents& e = boxes_[box_index(node)];
    const auto points = curves.points(node.piece, node.level);
    const auto j = static_cast<std::size_t>(node.index);
    const Position a = points[j];
    const Position b = points[j + 1 == points.size() ? 0 : j + 1];
    return {a,
            direction_of(b - a),
            static_cast<double>(e.along_low),
            static_cast<double>(e.along_high),
            static_cast<double>(e.across_low),
            static_cast<double>(e.across_high)};
}

Hit CollisionTree::first_hit(const CurveSet& curves, const Motion& motion,
                             const Budget& budget) const {
    FirstHit visitor(curves, motion, budget);
    const double unopened = TreeWalk(*this, curves, motion.level, visitor).run();
    return visitor.result(unopened);
}

Closest CollisionTree::closest_point(const CurveSet& curves, Position p, double level,
                                     double within_m, const Budget& budget) const {
    ClosestPoint visitor(curves, p, level, within_m, budget);
    const double unopened = TreeWalk(*this, curves, level, visitor).run();
    return visitor.result(unopened);
}

Clearance CollisionTree::clearance(const CurveSet& curves, Position p, double distance_m,
                                   double level, const Budget& budget) const {
    AnyNear visitor(p, distance_m, budget);
    const double unopened = TreeWalk(*this, curves, level, visitor).run();
    return visitor.result(unopened);
}

bool CollisionTree::is_alone(const CurveSet& curves, SegmentRef segment, double level) const {
    const int leaf = leaf_level(curves, segment.piece, level);
    const bool is_blend = curves.rendered_level(segment.piece, level) < leaf;
    return alone_[box_index({segment.piece, leaf, is_blend ? segment.index / 2 : segment.index})];
}

ErrorBox CollisionTree::box(const CurveSet& curves, int piece, int level, int j) const {
    return {corners_of(aligned_box(curves, {piece, level, j})), piece, level, j};
}

void CollisionTree::boundary_section(const CurveSet& curves, Position handle, int level,
                                     std::vector<ErrorBox>& section) const {
    std::vector<Node> open(roots_.rbegin(), roots_.rend());
    while (!open.empty()) {
        const Node node = open.back();
        open.pop_back();
        const bool holds = distance_m(aligned_box(curves, node), handle) <= 0.0;
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
