// Building the collision tree: boxes, the hierarchy over the coarsest segments, and who is alone.
#include "haptics/collision/collision_tree.h"
#include "haptics/collision/frame.h"
#include "haptics/collision/touch.h"
#include "haptics/collision/tree_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchline {
namespace {

float outward_low(double x) {
    return std::nextafterf(static_cast<float>(x), -INFINITY);
}

float outward_high(double x) {
    return std::nextafterf(static_cast<float>(x), INFINITY);
}

/// Looks for a box, not of a neighbour, that meets one node's box.
class Neighbourhood {
  public:
    Neighbourhood(const AlignedBox& box, double reach_m, SegmentRef self, SegmentRef before,
                  SegmentRef after)
        : box_(grown(box, reach_m)), reach_m_(reach_m), own_{self, before, after} {}

    std::optional<double> near(const AlignedBox& other) const {
        if (overlap(box_, grown(other, reach_m_))) return 0.0;
        return {};
    }

    [[nodiscard]] double cut() const { return is_met_ ? -1.0 : 0.0; }

    static bool spend() { return true; }

    void leaf(SegmentRef ref) {
        if (std::find(own_.begin(), own_.end(), ref) == own_.end()) is_met_ = true;
    }

    [[nodiscard]] bool is_met() const { return is_met_; }

  private:
    AlignedBox box_;
    double reach_m_;
    std::array<SegmentRef, 3> own_;
    bool is_met_ = false;
};

}  // namespace

class CollisionTreeBuilder {
  public:
    CollisionTreeBuilder(const CurveSet& curves, double radius_m)
        : curves_(curves), reach_m_(std::max(radius_m, contact_skin_m) + approach_tolerance_m) {}

    CollisionTree build() {
        for (int piece = 0; piece < static_cast<int>(curves_.pieces().size()); ++piece) {
            bound_piece(piece);
        }
        if (!tree_.roots_.empty()) {
            tree_.bounds_.emplace_back();
            bound_roots(0, 0, tree_.roots_.size());
        }
        find_alone();
        return std::move(tree_);
    }

  private:
    using Bound = CollisionTree::Bound;
    using Extents = CollisionTree::Extents;

    void bound_piece(int piece) {
        const int coarsest = curves_.pieces()[static_cast<std::size_t>(piece)].coarsest;
        tree_.first_level_.push_back(static_cast<std::uint32_t>(tree_.first_box_.size()));
        for (int level = 0; level <= coarsest; ++level) {
            tree_.first_box_.push_back(static_cast<std::uint32_t>(tree_.boxes_.size()));
            const int count = curves_.segment_count(piece, level);
            for (int j = 0; j < count; ++j) tree_.boxes_.push_back(extents(piece, level, j));
        }
        for (int j = 0; j < curves_.segment_count(piece, coarsest); ++j) {
            tree_.roots_.push_back({piece, coarsest, j});
        }
    }

    /// Holds the segment and the points of every finer level over its stretch.
    [[nodiscard]] Extents extents(int piece, int level, int j) const {
        const Segment s = curves_.rendered_segment(piece, level, j);
        const Direction u = direction_of(s.b - s.a);
        double s_low = 0.0;
        double s_high = norm(s.b - s.a);
        double n_low = 0.0;
        double n_high = 0.0;
        for (int finer = level - 1; finer >= 0; --finer) {
            const auto points = curves_.points(piece, finer);
            const auto first = static_cast<std::size_t>(j) << (level - finer);
            const auto segments = static_cast<std::size_t>(curves_.segment_count(piece, finer));
            const auto last =
                std::min((static_cast<std::size_t>(j) + 1) << (level - finer), segments);
            for (std::size_t i = first; i <= last; ++i) {
                const Position w = points[i == points.size() ? 0 : i] - s.a;
                s_low = std::min(s_low, dot(u, w));
                s_high = std::max(s_high, dot(u, w));
                n_low = std::min(n_low, cross(u, w));
                n_high = std::max(n_high, cross(u, w));
            }
        }
        return {outward_low(s_low), outward_high(s_high), outward_low(n_low), outward_high(n_high)};
    }

    /// Node `at` over roots [first, last), halved at the median of the longer side.
    void bound_roots(std::size_t at, std::size_t first, std::size_t last) {
        Bound bound = bound_of(first, last);
        if (last - first == 1) {
            bound.left = -static_cast<std::int32_t>(first) - 1;
            tree_.bounds_[at] = bound;
            return;
        }
        const bool is_wide = bound.x_high - bound.x_low >= bound.y_high - bound.y_low;
        const std::size_t middle = (first + last) / 2;
        const auto begin = tree_.roots_.begin();
        const auto place = [&](const CollisionTree::Node& node) {
            const Segment s = curves_.rendered_segment(node.piece, node.level, node.index);
            return is_wide ? s.a.x + s.b.x : s.a.y + s.b.y;
        };
        std::nth_element(begin + static_cast<std::ptrdiff_t>(first),
                         begin + static_cast<std::ptrdiff_t>(middle),
                         begin + static_cast<std::ptrdiff_t>(last),
                         [&](const auto& a, const auto& b) { return place(a) < place(b); });
        const std::size_t left = tree_.bounds_.size();
        bound.left = static_cast<std::int32_t>(left);
        tree_.bounds_[at] = bound;
        tree_.bounds_.resize(left + 2);
        bound_roots(left, first, middle);
        bound_roots(left + 1, middle, last);
    }

    [[nodiscard]] Bound bound_of(std::size_t first, std::size_t last) const {
        constexpr double far = std::numeric_limits<double>::infinity();
        double x_low = far;
        double x_high = -far;
        double y_low = far;
        double y_high = -far;
        for (std::size_t i = first; i < last; ++i) {
            for (const Position c : corners_of(tree_.aligned_box(curves_, tree_.roots_[i]))) {
                x_low = std::min(x_low, c.x);
                x_high = std::max(x_high, c.x);
                y_low = std::min(y_low, c.y);
                y_high = std::max(y_high, c.y);
            }
        }
        return {outward_low(x_low), outward_high(x_high), outward_low(y_low), outward_high(y_high),
                0};
    }

    void find_alone() {
        tree_.alone_.resize(tree_.boxes_.size());
        for (int piece = 0; piece < static_cast<int>(curves_.pieces().size()); ++piece) {
            const int coarsest = curves_.pieces()[static_cast<std::size_t>(piece)].coarsest;
            for (int level = 0; level <= coarsest; ++level) {
                for (int j = 0; j < curves_.segment_count(piece, level); ++j) {
                    tree_.alone_[tree_.box_index({piece, level, j})] = is_alone(piece, level, j);
                }
            }
        }
    }

    /// The coarsest nodes of a piece are also felt while other pieces are rendered coarser still.
    [[nodiscard]] bool is_alone(int piece, int level, int j) const {
        const bool is_coarsest =
            level == curves_.pieces()[static_cast<std::size_t>(piece)].coarsest;
        for (int others = level; others <= (is_coarsest ? curves_.coarsest() : level); ++others) {
            const double at = others;
            Neighbourhood visitor(tree_.aligned_box(curves_, {piece, level, j}), reach_m_,
                                  {piece, j}, curves_.previous({piece, j}, at),
                                  curves_.next({piece, j}, at));
            static_cast<void>(TreeWalk(tree_, curves_, at, visitor).run());
            if (visitor.is_met()) return false;
        }
        return true;
    }

    const CurveSet& curves_;
    double reach_m_;
    CollisionTree tree_;
};

CollisionTree CollisionTree::build(const CurveSet& curves, double radius_m) {
    return CollisionTreeBuilder(curves, radius_m).build();
}

}  // namespace touchline
