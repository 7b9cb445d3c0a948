// Building the collision tree: boxes, the hierarchy over the coarsest segments, and who is alone.
#include "haptics/collision/box.h"
#include "haptics/collision/collision_tree.h"
#include "haptics/collision/crowding.h"
#include "haptics/collision/touch.h"

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

/// Extents along and across an axis, in axis lengths, that grow to hold points.
class Growing {
  public:
    explicit Growing(const Segment& s)
        : origin_(s.a), axis_(frame_axis(s)), scale_(1.0 / dot(axis_, axis_)) {
        add(s.b);
    }

    void add(Position p) {
        const double s = dot(axis_, p - origin_);
        const double n = cross(axis_, p - origin_);
        s_low_ = std::min(s_low_, s);
        s_high_ = std::max(s_high_, s);
        n_low_ = std::min(n_low_, n);
        n_high_ = std::max(n_high_, n);
    }

    [[nodiscard]] PackedExtents packed() const {
        return {scale_ * s_low_, scale_ * s_high_, scale_ * n_low_, scale_ * n_high_};
    }

  private:
    Position origin_;
    Position axis_;
    double scale_;
    double s_low_ = 0.0, s_high_ = 0.0, n_low_ = 0.0, n_high_ = 0.0;
};

}  // namespace

class CollisionTreeBuilder {
  public:
    CollisionTreeBuilder(const CurveSet& curves, double radius_m)
        : curves_(curves), reach_m_(std::max(radius_m, contact_skin_m) + approach_tolerance_m) {}

    CollisionTree build() {
        tree_.extents_.resize(curves_.point_count() - curves_.finest_count());
        for (int piece = 0; piece < static_cast<int>(curves_.pieces().size()); ++piece) {
            bound_piece(piece);
        }
        if (!tree_.roots_.empty()) {
            tree_.bounds_.reserve(2 * tree_.roots_.size());
            tree_.bounds_.emplace_back();
            bound_roots(0, 0, tree_.roots_.size());
        }
        tree_.alone_ = Crowding(tree_, curves_, reach_m_).find_alone();
        return std::move(tree_);
    }

  private:
    using Bound = CollisionTree::Bound;

    void bound_piece(int piece) {
        const int coarsest = curves_.pieces()[static_cast<std::size_t>(piece)].coarsest;
        for (int level = 1; level <= coarsest; ++level) {
            const std::size_t first = curves_.first_point(piece, level) - curves_.finest_count();
            const int count = curves_.segment_count(piece, level);
            for (int j = 0; j < count; ++j) {
                tree_.extents_[first + static_cast<std::size_t>(j)] = extents(piece, level, j);
            }
        }
        for (int j = 0; j < curves_.segment_count(piece, coarsest); ++j) {
            tree_.roots_.push_back({piece, coarsest, j});
        }
    }

    /// Holds the segment and the points of every finer level over its stretch: points down to
    /// `scanned` levels below, then the boxes of that level, which hold the rest. O(2^scanned).
    [[nodiscard]] PackedExtents extents(int piece, int level, int j) const {
        constexpr int scanned = 4;
        Growing box(segment(piece, level, j));
        const int finest = std::max(level - scanned, 0);
        for (int finer = level - 1; finer >= finest; --finer)
            add_points(piece, level, j, finer, box);
        if (finest > 0) add_boxes(piece, level, j, finest, box);
        return box.packed();
    }

    void add_points(int piece, int level, int j, int finer, Growing& box) const {
        const auto points = curves_.points(piece, finer);
        const auto first = static_cast<std::size_t>(j) << (level - finer);
        const auto last = last_of(piece, level, j, finer);
        for (std::size_t i = first; i < last; ++i) box.add(points[i]);
        box.add(points[last == points.size() ? 0 : last]);
    }

    void add_boxes(int piece, int level, int j, int finer, Growing& box) const {
        const auto first = static_cast<std::size_t>(j) << (level - finer);
        const auto last = last_of(piece, level, j, finer);
        for (std::size_t i = first; i < last; ++i) {
            for (const Position corner :
                 corners_of(tree_.node_box(curves_, {piece, finer, static_cast<int>(i)}))) {
                box.add(corner);
            }
        }
    }

    /// One past the last segment of level `finer` over the stretch of segment j.
    [[nodiscard]] std::size_t last_of(int piece, int level, int j, int finer) const {
        return std::min((static_cast<std::size_t>(j) + 1) << (level - finer),
                        static_cast<std::size_t>(curves_.segment_count(piece, finer)));
    }

    [[nodiscard]] Segment segment(int piece, int level, int j) const {
        return curves_.rendered_segment(piece, level, j);
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
            const Segment s = segment(node.piece, node.level, node.index);
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
            for (const Position c : corners_of(tree_.node_box(curves_, tree_.roots_[i]))) {
                x_low = std::min(x_low, c.x);
                x_high = std::max(x_high, c.x);
                y_low = std::min(y_low, c.y);
                y_high = std::max(y_high, c.y);
            }
        }
        return {outward_low(x_low), outward_high(x_high), outward_low(y_low), outward_high(y_high),
                0};
    }

    const CurveSet& curves_;
    double reach_m_;
    CollisionTree tree_;
};

CollisionTree CollisionTree::build(const CurveSet& curves, double radius_m) {
    return CollisionTreeBuilder(curves, radius_m).build();
}

}  // namespace touchline
