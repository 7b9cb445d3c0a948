// Builds the collision tree: the boxes, the hierarchy over the coarsest segments, and which nodes
// are alone.
#include "haptics/collision/box.h"
#include "haptics/collision/collision_tree.h"
#include "haptics/collision/crowding.h"
#include "haptics/collision/touch.h"

#include <algorithm>
#include <cmath>

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
        held_.hold({s, s, n, n});
    }

    void add(const Box& box) { held_.hold(shadow(box, origin_, axis_)); }

    [[nodiscard]] PackedExtents packed() const {
        return {scale_ * held_.along_low, scale_ * held_.along_high, scale_ * held_.across_low,
                scale_ * held_.across_high};
    }

  private:
    Position origin_;
    Position axis_;
    double scale_;
    Shadow held_;
};

}  // namespace

class CollisionTreeBuilder {
  public:
    CollisionTreeBuilder(const CurveSet& curves, double radius_m)
        : curves_(curves), reach_m_(std::max(radius_m, contact_skin_m) + approach_tolerance_m) {}

    CollisionTree build() {
        tree_.extents_.resize(curves_.point_count() - curves_.finest_count() + Fan::width - 1);
        for (int piece = 0; piece < curves_.piece_count(); ++piece) bound_piece(piece);
        if (!tree_.roots_.empty()) {
            tree_.bounds_.reserve(2 * tree_.roots_.size());
            tree_.bounds_.emplace_back();
            bound_roots(0, 0, tree_.roots_.size());
            lay_grid();
        }
        tree_.alone_ = Crowding(tree_, curves_, reach_m_).find_alone();
        return std::move(tree_);
    }

  private:
    using Bound = CollisionTree::Bound;

    void bound_piece(int piece) {
        const int coarsest = curves_.piece(piece).coarsest;
        for (int level = 1; level <= coarsest; ++level) {
            const std::size_t first = curves_.first_point(piece, level) - curves_.finest_count();
            const int count = curves_.segment_count(piece, level);
            for (int j = 0; j < count; ++j) {
                tree_.extents_[first + static_cast<std::size_t>(j)] = extents(piece, level, j);
            }
        }
        add_stretches(piece, coarsest, tree_.roots_);
    }

    /// Adds a level of a piece, four neighbouring nodes at a time.
    void add_stretches(int piece, int level, std::vector<Stretch>& stretches) const {
        const int count = curves_.segment_count(piece, level);
        for (int first = 0; first < count; first += Fan::width) {
            stretches.push_back({piece, level, first, std::min(Fan::width, count - first)});
        }
    }

    /// Returns extents that hold the segment and the points of every finer level over its stretch:
    /// it takes points down to `scanned` levels below, then the boxes of that level, which hold the
    /// rest. O(2^scanned).
    [[nodiscard]] PackedExtents extents(int piece, int level, int j) const {
        constexpr int scanned = 3;
        Growing box(curves_.rendered_segment(piece, level, j));
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
            box.add(tree_.node_box(curves_, {piece, finer, static_cast<int>(i)}));
        }
    }

    /// Returns one past the last segment of level `finer` over the stretch of segment j.
    [[nodiscard]] std::size_t last_of(int piece, int level, int j, int finer) const {
        return std::min((static_cast<std::size_t>(j) + 1) << (level - finer),
                        static_cast<std::size_t>(curves_.segment_count(piece, finer)));
    }

    /// Builds node `at` over roots [first, last), halved at the median of the longer side.
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
        const auto place = [&](const Stretch& roots) {
            const Segment s =
                curves_.rendered_segment(roots.piece, roots.level, roots.first + roots.count / 2);
            return is_wide ? s.a.x + s.b.x : s.a.y + s.b.y;
        };
        std::ranges::nth_element(begin + static_cast<std::ptrdiff_t>(first),
                                 begin + static_cast<std::ptrdiff_t>(middle),
                                 begin + static_cast<std::ptrdiff_t>(last), {}, place);
        const std::size_t left = tree_.bounds_.size();
        bound.left = static_cast<std::int32_t>(left);
        tree_.bounds_[at] = bound;
        tree_.bounds_.resize(left + 2);
        bound_roots(left, first, middle);
        bound_roots(left + 1, middle, last);
    }

    [[nodiscard]] Bound bound_of(std::size_t first, std::size_t last) const {
        Shadow all = no_shadow;
        for (std::size_t i = first; i < last; ++i) all.hold(upright_shadow(tree_.roots_[i]));
        return {outward_low(all.along_low), outward_high(all.along_high),
                outward_low(all.across_low), outward_high(all.across_high), 0};
    }

    /// x along, y across.
    [[nodiscard]] Shadow upright_shadow(const Stretch& stretch) const {
        Shadow all = no_shadow;
        for (int j = stretch.first; j < stretch.first + stretch.count; ++j) {
            const Box box = tree_.node_box(curves_, {stretch.piece, stretch.level, j});
            all.hold(shadow(box, {}, {1.0, 0.0}));
        }
        return all;
    }

    /// The mean edge length at level 0.
    [[nodiscard]] double mean_edge_m() const {
        double length_m = 0.0;
        double edges = 0.0;
        for (int piece = 0; piece < curves_.piece_count(); ++piece) {
            const auto points = curves_.points(piece, 0);
            for (std::size_t i = 1; i < points.size(); ++i)
                length_m += norm(points[i] - points[i - 1]);
            edges += static_cast<double>(points.size() - 1);
        }
        return edges > 0.0 ? length_m / edges : 1.0;
    }

    /// Puts every piece into the grid, in stretches of four nodes of the level at which they are 1
    /// mm long, or of its coarsest level. All pieces have one starting level: a query at a level
    /// coarser than a stretch's cannot start there.
    void lay_grid() {
        constexpr double node_m = 1e-3;
        const double octaves = std::ceil(std::log2(node_m / std::max(mean_edge_m(), 1e-12)));
        const auto start_level = static_cast<int>(std::clamp(octaves, 0.0, 32.0));
        if (start_level < curves_.coarsest()) tree_.start_level_ = start_level;
        std::vector<Stretch> stretches;
        std::vector<Shadow> bounds;
        for (int piece = 0; piece < curves_.piece_count(); ++piece) {
            const int coarsest = curves_.piece(piece).coarsest;
            add_stretches(piece, std::min(start_level, coarsest), stretches);
        }
        for (const Stretch& stretch : stretches) bounds.push_back(upright_shadow(stretch));
        tree_.start_grid_ = StartGrid(std::move(stretches), bounds);
    }

    const CurveSet& curves_;
    double reach_m_;
    CollisionTree tree_;
};

CollisionTree CollisionTree::build(const CurveSet& curves, double radius_m) {
    return CollisionTreeBuilder(curves, radius_m).build();
}

}  // namespace touchline
