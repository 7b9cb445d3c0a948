#include "haptics/collision/collision_builder.h"

#include "haptics/collision/box.h"
#include "haptics/collision/touch.h"
#include "haptics/curve/large_pages.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace touchline {
namespace {

float outward_low(double x) {
    return std::nextafterf(static_cast<float>(x), -INFINITY);
}

float outward_high(double x) {
    return std::nextafterf(static_cast<float>(x), INFINITY);
}

using Pair = double __attribute__((vector_size(16)));

Pair smaller_pair(Pair a, Pair b) {
    return a < b ? a : b;
}

Pair larger_pair(Pair a, Pair b) {
    return b < a ? a : b;
}

/// Extents along and across an axis, in axis lengths, that grow to hold points. First along, then
/// across: two at once.
class Growing {
  public:
    explicit Growing(const Segment& s) {
        const Position axis = frame_axis(s);
        origin_ = Pair{s.a.x, s.a.y};
        by_first_ = Pair{axis.x, axis.x};
        by_second_ = Pair{axis.y, -axis.y};
        scale_ = 1.0 / dot(axis, axis);
        add(s.b);
    }

    void add(Position p) {
        const Pair at = turned(Pair{p.x, p.y} - origin_);
        hold(at, at);
    }

    /// As shadow() of box.h, two at once.
    void add(const Segment& s, const PackedExtents& e) {
        const Position own = frame_axis(s);
        const Pair at = turned(Pair{s.a.x, s.a.y} - origin_);
        const Pair axis = turned(Pair{own.x, own.y});
        const Pair along_one = e.along_low() * axis;
        const Pair along_other = e.along_high() * axis;
        const Pair across_one = e.across_low() * axis;
        const Pair across_other = e.across_high() * axis;
        const Pair across_low = smaller_pair(across_one, across_other);
        const Pair across_high = larger_pair(across_one, across_other);
        hold(at + smaller_pair(along_one, along_other) + Pair{-across_high[1], across_low[0]},
             at + larger_pair(along_one, along_other) + Pair{-across_low[1], across_high[0]});
    }

    [[nodiscard]] PackedExtents packed() const {
        return {scale_ * low_[0], scale_ * high_[0], scale_ * low_[1], scale_ * high_[1]};
    }

  private:
    [[nodiscard]] Pair turned(Pair w) const {
        return by_first_ * w + by_second_ * __builtin_shufflevector(w, w, 1, 0);
    }

    void hold(Pair low, Pair high) {
        low_ = smaller_pair(low, low_);
        high_ = larger_pair(high, high_);
    }

    Pair origin_;
    Pair by_first_;
    Pair by_second_;
    double scale_;
    Pair low_{};
    Pair high_{};
};

/// One level of a piece: its points, a closed one's first again after the last, and its boxes.
class LevelLine {
  public:
    LevelLine() = default;

    LevelLine(std::span<const Position> points, const PackedExtents* extents)
        : points_(points.data()), count_(points.size()), extents_(extents) {}

    [[nodiscard]] Segment segment(std::size_t j) const { return {points_[j], point(j + 1)}; }

    void add_points(std::size_t first, std::size_t last, Growing& box) const {
        for (std::size_t i = first; i < last; ++i) box.add(points_[i]);
        box.add(point(last));
    }

    /// The same from point j 2^octaves on, for a whole segment that much coarser.
    template <std::size_t octaves>
    [[gnu::always_inline]] void add_whole(std::size_t j, Growing& box) const {
        const Position* const points = points_ + (j << octaves);
#pragma GCC unroll 9
        for (std::size_t i = 0; i <= (std::size_t{1} << octaves); ++i) box.add(points[i]);
    }

    void add_boxes(std::size_t first, std::size_t last, Growing& box) const {
        for (std::size_t i = first; i < last; ++i) box.add(segment(i), extents_[i]);
    }

  private:
    [[nodiscard]] Position point(std::size_t i) const {
        return points_[i == count_ ? 0 : i];
    }

    const Position* points_ = nullptr;
    std::size_t count_ = 0;
    const PackedExtents* extents_ = nullptr;  // not of level 0
};

using Entry = KnownPieces::Entry;

/// Returns the one with the same points.
std::vector<Entry>::const_iterator find_entry(const std::vector<Entry>& entries,
                                              const Entry& wanted) {
    const auto start = [](const Entry& e) { return std::pair(e.outline, e.first_vertex); };
    const auto found = std::ranges::lower_bound(entries, start(wanted), {}, start);
    const bool is_same = found != entries.end() && start(*found) == start(wanted) &&
                         found->last_vertex == wanted.last_vertex && found->edges == wanted.edges &&
                         found->is_closed == wanted.is_closed;
    return is_same ? found : entries.end();
}

}  // namespace

CollisionTreeBuilder::CollisionTreeBuilder(const CurveSet& curves, KnownPieces known)
    : curves_(curves) {
    const std::size_t extents = curves.point_count() - curves.finest_count() + Fan::width - 1;
    reserve_in_large_pages(tree_.extents_, extents);
    tree_.extents_.resize(extents);
    std::vector<int> piece_of(known.entries.size(), -1);
    for (int piece = 0; piece < curves.piece_count(); ++piece) {
        const auto entry = find_entry(known.entries, entry_of(piece));
        is_known_.push_back(entry != known.entries.end());
        if (is_known_.back()) {
            piece_of[static_cast<std::size_t>(entry - known.entries.begin())] = piece;
            const std::span<PackedExtents> boxes = boxes_of(piece);
            std::copy_n(known.extents.begin() + static_cast<std::ptrdiff_t>(entry->first_box),
                        boxes.size(), boxes.begin());
            continue;
        }
        for (int level = 1; level <= curves.piece(piece).coarsest; ++level) {
            bound_level(piece, level);
        }
    }
    const auto take_over = [&](std::vector<MeetingNodes>& from, std::vector<MeetingNodes>& to) {
        for (MeetingNodes& pair : from) {
            for (SegmentRef& node : pair.nodes) {
                node.piece = piece_of[static_cast<std::size_t>(node.piece)];
            }
            if (pair.nodes[0].piece >= 0 && pair.nodes[1].piece >= 0) to.push_back(pair);
        }
    };
    take_over(known.meetings.pairs, known_meetings_.pairs);
    take_over(known.meetings.close, known_meetings_.close);
    hang();
}

KnownPieces::Entry CollisionTreeBuilder::entry_of(int piece) const {
    const Piece& own = curves_.piece(piece);
    const std::size_t first =
        own.coarsest > 0 ? curves_.first_point(piece, 1) : curves_.finest_count();
    return {own.outline,
            own.is_closed,
            own.first_vertex,
            own.last_vertex,
            curves_.segment_count(piece, 0),
            first - curves_.finest_count()};
}

/// Those of level 1 come first.
std::span<PackedExtents> CollisionTreeBuilder::boxes_of(int piece) {
    const int coarsest = curves_.piece(piece).coarsest;
    if (coarsest == 0) return {};
    const std::size_t first = curves_.first_point(piece, 1);
    const std::size_t last =
        curves_.first_point(piece, coarsest) + curves_.points(piece, coarsest).size();
    return std::span(tree_.extents_).subspan(first - curves_.finest_count(), last - first);
}

void CollisionTreeBuilder::hang() {
    tree_.roots_.clear();
    tree_.bounds_.clear();
    for (int piece = 0; piece < curves_.piece_count(); ++piece) {
        add_stretches(piece, curves_.piece(piece).coarsest, tree_.roots_);
    }
    if (tree_.roots_.empty()) return;
    std::vector<Root> roots;
    roots.reserve(tree_.roots_.size());
    for (const Stretch& stretch : tree_.roots_) {
        const Segment s = curves_.rendered_segment(stretch.piece, stretch.level,
                                                   stretch.first + stretch.count / 2);
        roots.push_back({stretch, upright_shadow(stretch), s.a + s.b});
    }
    tree_.bounds_.reserve(2 * roots.size());
    tree_.bounds_.emplace_back();
    bound_roots(0, roots, 0);
    std::ranges::transform(roots, tree_.roots_.begin(), &Root::stretch);
}

Meetings CollisionTreeBuilder::find_meetings() {
    Meetings found = Crowding(tree_, curves_, contact_skin_m)
                         .find_meetings(std::move(known_meetings_), is_known_);
    close_ = found.close;
    return found;
}

KnownPieces CollisionTreeBuilder::known_pieces(Meetings meetings) && {
    KnownPieces known{{}, std::move(tree_.extents_), std::move(meetings)};
    for (int piece = 0; piece < curves_.piece_count(); ++piece) {
        known.entries.push_back(entry_of(piece));
    }
    return known;
}

CollisionTree CollisionTreeBuilder::finish(double radius_m) && {
    const double reach_m = std::max(radius_m, contact_skin_m) + approach_tolerance_m;
    if (!tree_.roots_.empty()) lay_grid(reach_m);
    tree_.alone_ = Crowding(tree_, curves_, reach_m).find_alone(close_);
    return std::move(tree_);
}

/// Bounds the segments of a level and the points of every finer one over their stretches: takes
/// points down to `scanned` levels below, then the boxes of that level, which hold the rest.
/// O(2^scanned) a segment.
void CollisionTreeBuilder::bound_level(int piece, int level) {
    constexpr int scanned = 3;
    const int scans = std::min(level, scanned);
    const auto line_of = [&](int at) {
        const std::size_t first = curves_.first_point(piece, at);
        const bool has_boxes = at > 0;
        return LevelLine(
            curves_.points(piece, at),
            has_boxes ? tree_.extents_.data() + (first - curves_.finest_count()) : nullptr);
    };
    std::array<LevelLine, scanned + 1> lines;  // from this level to finer ones
    std::array<std::size_t, scanned + 1> counts{};
    for (int k = 0; k <= scans; ++k) {
        lines[static_cast<std::size_t>(k)] = line_of(level - k);
        counts[static_cast<std::size_t>(k)] =
            static_cast<std::size_t>(curves_.segment_count(piece, level - k));
    }
    PackedExtents* const extents =
        tree_.extents_.data() + (curves_.first_point(piece, level) - curves_.finest_count());
    const std::size_t wholes = (counts[static_cast<std::size_t>(scans)] - 1) >> scans;
    for (std::size_t j = 0; j < wholes; ++j) {
        Growing box(lines[0].segment(j));
        lines[1].add_whole<1>(j, box);
        if (level > 1) lines[2].add_whole<2>(j, box);
        if (level > 2) lines[3].add_whole<3>(j, box);
        if (level > scanned) lines[scanned].add_boxes(j << scanned, (j + 1) << scanned, box);
        extents[j] = box.packed();
    }
    for (std::size_t j = wholes; j < counts[0]; ++j) {
        Growing box(lines[0].segment(j));
        for (std::size_t k = 1; k <= static_cast<std::size_t>(scans); ++k) {
            lines[k].add_points(j << k, std::min((j + 1) << k, counts[k]), box);
        }
        if (level > scanned) {
            lines[scanned].add_boxes(j << scanned, std::min((j + 1) << scanned, counts[scanned]),
                                     box);
        }
        extents[j] = box.packed();
    }
}

/// Adds a level of a piece, four neighbouring nodes at a time.
void CollisionTreeBuilder::add_stretches(int piece, int level,
                                         std::vector<Stretch>& stretches) const {
    const int count = curves_.segment_count(piece, level);
    for (int first = 0; first < count; first += Fan::width) {
        stretches.push_back({piece, level, first, std::min(Fan::width, count - first)});
    }
}

/// Builds node `at` over roots, of which `first` come before, halved at the median of the longer
/// side.
void CollisionTreeBuilder::bound_roots(std::size_t at, std::span<Root> roots, std::size_t first) {
    Shadow all = no_shadow;
    for (const Root& root : roots) all.hold(root.shadow);
    CollisionTree::Bound bound{outward_low(all.along_low), outward_high(all.along_high),
                               outward_low(all.across_low), outward_high(all.across_high), 0};
    if (roots.size() == 1) {
        bound.left = -static_cast<std::int32_t>(first) - 1;
        tree_.bounds_[at] = bound;
        return;
    }
    const bool is_wide = bound.x_high - bound.x_low >= bound.y_high - bound.y_low;
    const std::size_t middle = (2 * first + roots.size()) / 2 - first;
    const auto place = [is_wide](const Root& root) {
        return is_wide ? root.middle.x : root.middle.y;
    };
    std::ranges::nth_element(roots, roots.begin() + static_cast<std::ptrdiff_t>(middle), {}, place);
    const std::size_t left = tree_.bounds_.size();
    bound.left = static_cast<std::int32_t>(left);
    tree_.bounds_[at] = bound;
    tree_.bounds_.resize(left + 2);
    bound_roots(left, roots.first(middle), first);
    bound_roots(left + 1, roots.subspan(middle), first + middle);
}

/// x along, y across.
Shadow CollisionTreeBuilder::upright_shadow(const Stretch& stretch) const {
    Shadow all = no_shadow;
    for (int j = stretch.first; j < stretch.first + stretch.count; ++j) {
        const Box box = tree_.node_box(curves_, {stretch.piece, stretch.level, j});
        all.hold(shadow(box, {}, {1.0, 0.0}));
    }
    return all;
}

/// The mean edge length at level 0.
double CollisionTreeBuilder::mean_edge_m() const {
    double length_m = 0.0;
    double edges = 0.0;
    for (int piece = 0; piece < curves_.piece_count(); ++piece) {
        const auto points = curves_.points(piece, 0);
        for (std::size_t i = 1; i < points.size(); ++i) length_m += norm(points[i] - points[i - 1]);
        edges += static_cast<double>(points.size() - 1);
    }
    return edges > 0.0 ? length_m / edges : 1.0;
}

/// Puts every piece into the grid, in stretches of four nodes of the level at which they are 1
/// mm long, or of its coarsest level. All pieces have one starting level: a query at a level
/// coarser than a stretch's cannot start there.
void CollisionTreeBuilder::lay_grid(double reach_m) {
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
    std::vector<StartGrid::Nodes> nodes;
    CollisionTree::FanBuffer buffer{};
    for (const Stretch& stretch : stretches) {
        nodes.push_back({stretch, ready(tree_.fan(curves_, stretch, buffer))});
        for (int j = stretch.first; j < stretch.first + stretch.count; ++j) {
            bounds.push_back(upright_shadow({stretch.piece, stretch.level, j, 1}));
        }
    }
    tree_.start_grid_ = StartGrid(std::move(nodes), bounds, reach_m);
}

CollisionTree CollisionTree::build(const CurveSet& curves, double radius_m) {
    return CollisionTreeBuilder(curves).finish(radius_m);
}

}  // namespace touchline
