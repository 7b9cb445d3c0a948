#include "haptics/collision/collision_tree.h"

#include "haptics/collision/row_scan.h"
#include "haptics/collision/tree_walk.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

/// Returns distances as keys, rounded down.
Sifted distances(const Fan& fan, Position p) {
    Sifted out{(1U << static_cast<unsigned>(fan.count)) - 1U, {}, 0.0F};
    for (std::size_t k = 0; k < static_cast<std::size_t>(fan.count); ++k) {
        const auto distance = static_cast<float>(distance_m(fan.box(k), p));
        out.key[k] = distance > 0.0F ? std::nextafterf(distance, 0.0F) : 0.0F;
    }
    return out;
}

class FirstHit : public FirstTouch {
  public:
    static constexpr bool asks_leaf_boxes = false;

    FirstHit(const Motion& motion, const Budget& budget) : FirstTouch(motion), spender_(budget) {}

    bool spend(int boxes) { return spender_.spend(boxes); }

    void leaf(SegmentRef ref, const Segment& segment) { test(ref, segment); }

    /// Leaves out nodes of these edges, which have been shown to it.
    void leave_out(const Stretch& edges) { seen_ = edges; }

    [[nodiscard]] bool has_seen(const Stretch& node) const {
        if (node.piece != seen_.piece) return false;
        const int octaves = node.level - seen_.level;
        const int first = node.first << octaves;
        const int last = (node.first + node.count) << octaves;
        return first >= seen_.first && last <= seen_.first + seen_.count;
    }

    Hit result(double unopened) { return FirstTouch::result(unopened, spender_.opened()); }

  private:
    Spender spender_;
    Stretch seen_{-1, 0, 0, 0};  // none
};

/// What visitors that look for what is nearest to a place have in common.
class AroundPlace {
  public:
    AroundPlace(Position p, const Budget& budget) : p_(p), spender_(budget) {}

    static void spare(double /*margin_m*/) {}

    [[nodiscard]] Sifted sift(const Fan& fan) const { return distances(fan, p_); }

    [[nodiscard]] std::optional<double> near(const Box& box) const { return distance_m(box, p_); }

    bool spend(int boxes) { return spender_.spend(boxes); }

  protected:
    [[nodiscard]] Position p() const { return p_; }

    [[nodiscard]] int opened() const { return spender_.opened(); }

  private:
    Position p_;
    Spender spender_;
};

class ClosestPoint : public AroundPlace {
  public:
    static constexpr bool asks_leaf_boxes = false;

    ClosestPoint(Position p, double within_m, const Budget& budget) : AroundPlace(p, budget) {
        closest_.distance_m = within_m;
    }

    [[nodiscard]] double cut() const { return closest_.distance_m; }

    void leaf(SegmentRef ref, const Segment& segment) {
        const Foot at = foot(p(), segment);
        const bool is_nearer = at.distance_m < closest_.distance_m;
        const bool is_lower = at.distance_m == closest_.distance_m && closest_.segment.piece >= 0 &&
                              ref < closest_.segment;
        if (!is_nearer && !is_lower) return;
        closest_ = {ref, at.parameter, at.point, at.distance_m, 0, true};
    }

    /// `unopened` is the distance of the nearest box left unopened.
    Closest result(double unopened) {
        closest_.boxes = opened();
        closest_.is_complete = unopened > closest_.distance_m;
        return closest_;
    }

  private:
    Closest closest_;
};

/// Stops at the first leaf's box within reach.
class AnyNear : public AroundPlace {
  public:
    static constexpr bool asks_leaf_boxes = true;

    AnyNear(Position p, double reach_m, const Budget& budget)
        : AroundPlace(p, budget), reach_m_(reach_m) {}

    [[nodiscard]] double cut() const { return is_met_ ? -1.0 : reach_m_; }

    void leaf(SegmentRef /*ref*/, const Segment& /*segment*/) { is_met_ = true; }

    [[nodiscard]] Clearance result(double unopened) const {
        return {!is_met_ && unopened > reach_m_, opened()};
    }

  private:
    double reach_m_;
    bool is_met_ = false;
};

/// The coarser level's boxes hold every blend, so whatever may sweep over p has its box there.
class FirstWall {
  public:
    static constexpr bool asks_leaf_boxes = false;

    FirstWall(const CurveSet& curves, Position p, const LevelChange& change,
              const std::array<SegmentRef, 2>& excluded, const Budget& budget)
        : curves_(curves),
          way_{p, {}, contact_skin_m},
          change_(change),
          excluded_(excluded),
          spender_(budget) {}

    [[nodiscard]] const Way& way() const { return way_; }

    static void spare(double /*margin_m*/) {}

    [[nodiscard]] Sifted sift(const auto& fan) const { return touchline::sift(fan, way_); }

    [[nodiscard]] std::optional<double> near(const Box& box) const {
        return approach(box, way_).is_met ? std::optional(0.0) : std::nullopt;
    }

    /// Whatever comes within the skin may be first.
    [[nodiscard]] static double cut() { return 0.0; }

    bool spend(int boxes) { return spender_.spend(boxes); }

    void leaf(SegmentRef ref, const Segment& /*between*/) {
        const bool has_octave = change_.finer < curves_.piece(ref.piece).coarsest;
        if (!has_octave || ref == excluded_[0] || ref == excluded_[1]) return;
        look_up(ref.piece);
        const auto found = meeting(way_.from, from_.segment(ref.index), to_.segment(ref.index));
        if (!found) return;
        const bool is_lower = found->share == hit_.share && hit_.is_hit && ref < hit_.segment;
        if (!(found->share < hit_.share || is_lower || !hit_.is_hit)) return;
        hit_ = {true, true, found->share, ref, found->parameter, found->was_left, 0};
    }

    WallHit result(double unopened) {
        hit_.boxes = spender_.opened();
        hit_.is_complete = !std::isfinite(unopened);
        return hit_;
    }

  private:
    void look_up(int piece) {
        if (piece == piece_) return;
        piece_ = piece;
        from_ = curves_.blend(piece, change_.finer, change_.from);
        to_ = curves_.blend(piece, change_.finer, change_.to);
    }

    const CurveSet& curves_;
    Way way_;
    const LevelChange& change_;
    const std::array<SegmentRef, 2>& excluded_;
    Spender spender_;
    int piece_ = -1;  // whose these are:
    RenderedPiece from_, to_;
    WallHit hit_;
};

}  // namespace

Hit CollisionTree::first_hit(const CurveSet& curves, const Motion& motion,
                             const Budget& budget) const {
    FirstHit visitor(motion, budget);
    const double unopened = TreeWalk(*this, curves, motion.level, visitor).run_near(visitor.way());
    return visitor.result(unopened);
}

Hit CollisionTree::first_hit_from(const CurveSet& curves, const Motion& motion, SegmentRef start,
                                  const Budget& budget) const {
    FirstHit visitor(motion, budget);
    RowScan scan(*this, curves, motion.level, visitor);
    if (scan.run(start)) return visitor.result(INFINITY);
    visitor.leave_out(scan.shown());
    TreeWalk walk(*this, curves, motion.level, visitor);
    return visitor.result(walk.run_near(visitor.way()));
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
    const double unopened = TreeWalk(*this, curves, level, visitor).run_near({p, {}, distance_m});
    return visitor.result(unopened);
}

WallHit CollisionTree::first_wall(const CurveSet& curves, Position p, const LevelChange& change,
                                  const std::array<SegmentRef, 2>& excluded,
                                  const Budget& budget) const {
    FirstWall visitor(curves, p, change, excluded, budget);
    TreeWalk walk(*this, curves, change.finer + 0.5, visitor);
    return visitor.result(walk.run_near(visitor.way()));
}

NodeRange CollisionTree::nodes(const CurveSet& curves, int piece, double level) {
    const double rendered = curves.rendered_level(piece, level);
    const auto leaf = static_cast<int>(std::ceil(rendered));
    return {curves.first_point(piece, leaf), rendered < leaf};
}

TreeChildren CollisionTree::children(const CurveSet& curves, const TreeNode& node) const {
    if (node.piece >= 0) {
        if (node.level == 0) return {};
        const int first = 2 * node.index;
        const int level = node.level - 1;
        const bool has_two = first + 1 < curves.segment_count(node.piece, level);
        return {{{{node.piece, level, first}, {node.piece, level, first + 1}}}, has_two ? 2 : 1};
    }
    const Bound& bound = bounds_[static_cast<std::size_t>(node.index)];
    if (bound.left >= 0) return {{{{-1, 0, bound.left}, {-1, 0, bound.left + 1}}}, 2};
    const Stretch& roots = roots_[static_cast<std::size_t>(-bound.left - 1)];
    TreeChildren out;
    for (; out.count < roots.count; ++out.count) {
        out.nodes[static_cast<std::size_t>(out.count)] = {roots.piece, roots.level,
                                                          roots.first + out.count};
    }
    return out;
}

ErrorBox CollisionTree::box(const CurveSet& curves, int piece, int level, int j) const {
    return {corners_of(node_box(curves, {piece, level, j})), piece, level, j};
}

std::size_t CollisionTree::memory_bytes() const {
    return extents_.capacity() * sizeof(PackedExtents) + alone_.memory_bytes() +
           bounds_.capacity() * sizeof(Bound) + roots_.capacity() * sizeof(Stretch) +
           start_grid_.memory_bytes();
}

void CollisionTree::boundary_section(const CurveSet& curves, Position handle, int level,
                                     std::vector<ErrorBox>& section) const {
    std::vector<TreeNode> open;
    for (const Stretch& roots : roots_) {
        for (int k = 0; k < roots.count; ++k) {
            open.push_back({roots.piece, roots.level, roots.first + k});
        }
    }
    while (!open.empty()) {
        const TreeNode node = open.back();
        open.pop_back();
        const bool holds = distance_m(node_box(curves, node), handle) <= 0.0;
        if (!holds || node.level <= level || node.level == 0) {
            section.push_back(box(curves, node.piece, node.level, node.index));
            continue;
        }
        const TreeChildren finer = children(curves, node);
        for (int k = finer.count; k-- > 0;)
            open.push_back(finer.nodes[static_cast<std::size_t>(k)]);
    }
}

/// The boxes that a motion meets at one level, refined to the next finer one.
class LevelByLevel {
  public:
    LevelByLevel(const CollisionTree& tree, const CurveSet& curves, const Motion& motion,
                 const Budget& budget)
        : tree_(tree), curves_(curves), motion_(motion), first_(motion), spender_(budget) {}

    HitAtLevel run() {
        if (!gather_roots()) return unknown();
        const auto wanted = static_cast<int>(std::ceil(motion_.level));
        int level = curves_.coarsest();
        while (level > wanted && refine(level)) --level;
        const bool is_wanted = level <= wanted;
        return answer(is_wanted ? motion_.level : level);
    }

  private:
    /// A tree's node without initial values, which 24 KB of them would take longer to set than to
    /// use.
    struct Node {
        std::int32_t piece, level, index;
    };

    /// A list of fixed size that refuses what does not fit.
    struct Nodes {
        static constexpr std::size_t capacity = 1024;

        std::array<Node, capacity> at;
        std::size_t size = 0;

        bool add(const Node& node) {
            if (size == capacity) return false;
            at[size++] = node;
            return true;
        }
    };

    bool gather_roots() {
        if (tree_.bounds_.empty()) return true;
        std::array<std::int32_t, 40> open;  // of a hierarchy over 2^32 stretches
        std::size_t size = 0;
        open[size++] = 0;
        while (size > 0) {
            const auto& bound = tree_.bounds_[static_cast<std::size_t>(open[--size])];
            if (!first_.near(bound.box())) continue;
            if (bound.left >= 0) {
                if (!spender_.spend(1)) return false;
                open[size++] = bound.left;
                open[size++] = bound.left + 1;
                continue;
            }
            const Stretch& roots = tree_.roots_[static_cast<std::size_t>(-bound.left - 1)];
            if (!spender_.spend(std::max(roots.count - 1, 1))) return false;
            if (!add_near(roots, *nodes_)) return false;
        }
        return true;
    }

    bool add_near(const Stretch& stretch, Nodes& to) {
        const Fan fan = tree_.fan(curves_, stretch, buffer_);
        const unsigned near = first_.sift(fan).near;
        for (int k = 0; k < stretch.count; ++k) {
            const bool is_near = (near & (1U << k)) != 0;
            if (is_near && !to.add({stretch.piece, stretch.level, stretch.first + k})) return false;
        }
        return true;
    }

    /// Refines from `level` to the next finer one. Returns false, and changes nothing, if the
    /// budget or the room does not suffice.
    bool refine(int level) {
        finer_->size = 0;
        for (std::size_t i = 0; i < nodes_->size; ++i) {
            const Node& node = nodes_->at[i];
            if (node.level < level) {
                if (!finer_->add(node)) return false;
                continue;
            }
            const int first = 2 * node.index;
            const int count =
                std::min(2, curves_.segment_count(node.piece, node.level - 1) - first);
            if (!spender_.spend(1)) return false;
            if (!add_near({node.piece, node.level - 1, first, count}, *finer_)) return false;
        }
        std::swap(nodes_, finer_);
        return true;
    }

    HitAtLevel answer(double level) {
        for (std::size_t i = 0; i < nodes_->size; ++i) {
            const Node& node = nodes_->at[i];
            const RenderedPiece piece = curves_.rendered(node.piece, level);
            const bool is_blend = CollisionTree::nodes(curves_, node.piece, level).is_blend;
            const int first = is_blend ? 2 * node.index : node.index;
            const int last = std::min(first + (is_blend ? 2 : 1), piece.segment_count());
            for (int j = first; j < last; ++j) first_.test({node.piece, j}, piece.segment(j));
        }
        return {first_.result(INFINITY, spender_.opened()), level, true};
    }

    HitAtLevel unknown() {
        HitAtLevel nothing;
        nothing.hit.clear = 0.0;
        nothing.hit.boxes = spender_.opened();
        nothing.level = curves_.coarsest();
        return nothing;
    }

    const CollisionTree& tree_;
    const CurveSet& curves_;
    const Motion& motion_;
    FirstTouch first_;
    Spender spender_;
    CollisionTree::FanBuffer buffer_{};
    std::array<Nodes, 2> lists_;
    Nodes* nodes_ = &lists_[0];
    Nodes* finer_ = &lists_[1];
};

HitAtLevel CollisionTree::first_hit_at_level_reached(const CurveSet& curves, const Motion& motion,
                                                     const Budget& budget) const {
    return LevelByLevel(*this, curves, motion, budget).run();
}

}  // namespace touchline
