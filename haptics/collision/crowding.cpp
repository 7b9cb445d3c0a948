#include "haptics/collision/crowding.h"

#include "haptics/collision/box.h"
#include "haptics/collision/touch.h"

#include <algorithm>
#include <array>
#include <bit>
#include <span>

namespace touchline {
namespace {

constexpr double point_reach_m = 2.0 * (contact_skin_m + approach_tolerance_m);
constexpr double fast_hand_spacing_m = 1.25e-3;  // a quarter of 0.5 m/s over 100 Hz

/// A segment whose ends move straight and evenly.
struct MovingSegment {
    Segment from, to;
};

Segment seen_from(Position p, const Segment& s) {
    return {s.a - p, s.b - p};
}

/// Returns whether an end of one passes over the other.
bool passes_over(const MovingSegment& one, const MovingSegment& other) {
    const auto meets = [&](Position from, Position to) {
        return meeting({}, seen_from(from, other.from), seen_from(to, other.to)).has_value();
    };
    return meets(one.from.a, one.to.a) || meets(one.from.b, one.to.b);
}

/// The changes of level of one set of curves, from fine to coarse; pieces with an unsafe change
/// stay behind.
class Changes {
  public:
    explicit Changes(const CurveSet& curves) : curves_(curves) {
        for (const Piece& piece : curves.pieces()) safe_.coarsest.push_back(piece.coarsest);
    }

    void forbid_all() { std::ranges::fill(safe_.coarsest, 0); }

    /// Looks at the pairs of one level, after those of all finer levels. A piece that stays behind
    /// stands still from then on, which may put it in the way of others, so this repeats until
    /// nothing changes.
    void look_at(const MeetingNodes* first, const MeetingNodes* last) {
        bool is_changed = true;
        while (is_changed) {
            is_changed = false;
            for (const MeetingNodes* pair = first; pair != last; ++pair) {
                const int level = pair->level;
                const bool is_any = moves(pair->nodes[0], level) || moves(pair->nodes[1], level);
                if (!is_any || !do_meet(*pair)) continue;
                forbid(pair->nodes[0], level);
                forbid(pair->nodes[1], level);
                is_changed = true;
            }
        }
    }

    [[nodiscard]] SafeLevels safe() && { return std::move(safe_); }

  private:
    [[nodiscard]] int coarsest(SegmentRef node) const {
        return safe_.coarsest[static_cast<std::size_t>(node.piece)];
    }

    [[nodiscard]] bool moves(SegmentRef node, int level) const { return coarsest(node) >= level; }

    void forbid(SegmentRef node, int level) {
        if (!moves(node, level)) return;
        safe_.coarsest[static_cast<std::size_t>(node.piece)] = level - 1;
        safe_.unsafe.push_back({node, level});
    }

    [[nodiscard]] bool do_meet(const MeetingNodes& pair) const {
        const std::vector<MovingSegment> one = segments(pair.nodes[0], pair.level);
        const std::vector<MovingSegment> other = segments(pair.nodes[1], pair.level);
        return std::ranges::any_of(one, [&](const MovingSegment& a) {
            return std::ranges::any_of(other, [&](const MovingSegment& b) {
                return passes_over(a, b) || passes_over(b, a);
            });
        });
    }

    /// Returns what the node holds on the way from `level` - 1 to `level`.
    [[nodiscard]] std::vector<MovingSegment> segments(SegmentRef node, int level) const {
        const bool is_moving = moves(node, level);
        const int finer = is_moving ? level - 1 : coarsest(node);
        const int own = std::min(level, curves_.piece(node.piece).coarsest);
        const RenderedPiece from = curves_.blend(node.piece, finer, 0.0);
        const RenderedPiece to = curves_.blend(node.piece, finer, is_moving ? 1.0 : 0.0);
        const int first = node.index << (own - finer);
        const int last = std::min((node.index + 1) << (own - finer), from.segment_count());
        std::vector<MovingSegment> found;
        for (int j = first; j < last; ++j) found.push_back({from.segment(j), to.segment(j)});
        return found;
    }

    const CurveSet& curves_;
    SafeLevels safe_;
};

}  // namespace

Crowding::Crowding(const CollisionTree& tree, const CurveSet& curves, double reach_m)
    : tree_(tree),
      curves_(curves),
      reach_m_(2.0 * reach_m),
      is_known_(static_cast<std::size_t>(curves.piece_count()), false),
      left_(64 * curves.point_count() + 4096) {}

NodeFlags Crowding::find_alone(const std::optional<std::vector<MeetingNodes>>& close) {
    is_close_known_ = close.has_value() && reach_m_ <= point_reach_m;
    if (is_close_known_) close_ = *close;
    alone_ = NodeFlags(curves_.point_count(), true);
    settled_.assign(curves_.point_count(), false);
    walk();
    if (left_ == 0) alone_ = NodeFlags(curves_.point_count(), false);
    return std::move(alone_);
}

Meetings Crowding::find_meetings(Meetings known, const std::vector<bool>& is_known) {
    meetings_ = std::move(known);
    is_known_ = is_known;
    put_known_in_order();
    walk();
    std::ranges::sort(meetings_.pairs);
    std::ranges::stable_sort(meetings_.close, {},
                             [](const MeetingNodes& pair) { return pair.nodes[0].piece; });
    meetings_.is_complete = left_ > 0;
    return std::move(meetings_);
}

/// The walk meets nodes under different roots in the order in which their roots lie in the
/// hierarchy.
void Crowding::put_known_in_order() {
    if (meetings_.pairs.empty()) return;
    std::vector<int> first_stretch;  // per piece, in `place`
    int stretches = 0;
    for (int piece = 0; piece < curves_.piece_count(); ++piece) {
        first_stretch.push_back(stretches);
        const int roots = curves_.segment_count(piece, curves_.piece(piece).coarsest);
        stretches += (roots + Fan::width - 1) / Fan::width;
    }
    std::vector<int> place(tree_.roots_.size());  // of a piece's stretches, in the hierarchy
    const auto place_of = [&](SegmentRef root) -> int& {
        return place[static_cast<std::size_t>(first_stretch[static_cast<std::size_t>(root.piece)] +
                                              root.index / Fan::width)];
    };
    for (std::size_t i = 0; i < tree_.roots_.size(); ++i) {
        place_of({tree_.roots_[i].piece, tree_.roots_[i].first}) = static_cast<int>(i);
    }
    for (auto& [level, nodes] : meetings_.pairs) {
        const SegmentRef a = root_of(nodes[0], level);
        const SegmentRef b = root_of(nodes[1], level);
        const bool is_along_piece =
            a.piece == b.piece && (a == b || are_neighbours(a, b, curves_.coarsest()));
        if (!is_along_piece && place_of(b) < place_of(a)) std::swap(nodes[0], nodes[1]);
    }
}

void Crowding::walk() {
    find_known_bounds();
    if (!tree_.bounds_.empty()) within_hierarchy(0);
    for (int piece = 0; piece < curves_.piece_count(); ++piece) {
        if (is_known_[static_cast<std::size_t>(piece)]) continue;
        for (int level = curves_.piece(piece).coarsest - 1; level >= finest(); --level) {
            along_level(piece, level);
        }
    }
}

/// Children come after their parents.
void Crowding::find_known_bounds() {
    is_known_bound_.resize(tree_.bounds_.size());
    for (std::size_t i = tree_.bounds_.size(); i-- > 0;) {
        const int left = tree_.bounds_[i].left;
        const auto child = static_cast<std::size_t>(left);
        is_known_bound_[i] = left < 0
                                 ? is_known_[static_cast<std::size_t>(
                                       tree_.roots_[static_cast<std::size_t>(-left - 1)].piece)]
                                 : is_known_bound_[child] && is_known_bound_[child + 1];
    }
}

void Crowding::within_hierarchy(std::size_t bound) {
    if (is_known_bound_[bound]) return;
    const auto left = tree_.bounds_[bound].left;
    if (left < 0) {
        const auto roots = static_cast<std::size_t>(-left - 1);
        return between_roots(roots, roots);
    }
    const auto child = static_cast<std::size_t>(left);
    within_hierarchy(child);
    within_hierarchy(child + 1);
    between_bounds(child, child + 1);
}

/// Opens both, so that the depth stays that of the hierarchy.
void Crowding::between_bounds(std::size_t a, std::size_t b) {
    const auto& bound_a = tree_.bounds_[a];
    const auto& bound_b = tree_.bounds_[b];
    if (left_ == 0 || (is_known_bound_[a] && is_known_bound_[b])) return;
    --left_;
    if (!overlap(bound_a.box(), bound_b.box(), reach_m_)) return;
    if (bound_a.left < 0 && bound_b.left < 0) {
        between_roots(static_cast<std::size_t>(-bound_a.left - 1),
                      static_cast<std::size_t>(-bound_b.left - 1));
        return;
    }
    const auto first = [](std::size_t at, const CollisionTree::Bound& bound) {
        return bound.left < 0 ? at : static_cast<std::size_t>(bound.left);
    };
    const auto last = [](std::size_t at, const CollisionTree::Bound& bound) {
        return bound.left < 0 ? at : static_cast<std::size_t>(bound.left) + 1;
    };
    for (std::size_t i = first(a, bound_a); i <= last(a, bound_a); ++i) {
        for (std::size_t j = first(b, bound_b); j <= last(b, bound_b); ++j) between_bounds(i, j);
    }
}

/// Compares nodes that are not neighbours although their parents are: the next but one, and from an
/// even node the one after that. All others of the piece are met through parents that meet.
void Crowding::along_level(int piece, int level) {
    const int count = curves_.segment_count(piece, level);
    const std::size_t points = curves_.points(piece, level).size();
    // Fours with as many nodes and a point behind them.
    const std::size_t fours = points < 9 ? 0 : (points - 5) / Fan::width;
    if (level > 0 && is_close_known_) {
        look_at_close(piece, level);
    } else {
        sift_along(piece, level, fours);
    }
    for (int j = static_cast<int>(fours) * Fan::width; j < count; ++j) {
        look_ahead(piece, level, j, 2);
        if (j % 2 == 0) look_ahead(piece, level, j, 3);
    }
}

void Crowding::sift_along(int piece, int level, std::size_t fours) {
    const auto points = curves_.points(piece, level);
    const PackedExtents* const extents =
        level == 0
            ? nullptr
            : tree_.extents_.data() + (curves_.first_point(piece, level) - curves_.finest_count());
    const auto look_at = [&](unsigned near, int first, int ahead) {
        for (; near != 0; near &= near - 1) {
            const int j = first + std::countr_zero(near);
            if (is_pair_wanted()) {
                meetings_.close.push_back({level, {{{piece, j}, {piece, j + ahead}}}});
            }
            look_ahead(piece, level, j, ahead);
        }
    };
    const double reach_m = is_pair_wanted() ? point_reach_m : reach_m_;
    std::array<Apart, 64> sifted;
    int j = 0;
    for (std::size_t done = 0; done < fours; done += sifted.size()) {
        const auto some = std::span(sifted).first(std::min(sifted.size(), fours - done));
        const auto first = static_cast<std::size_t>(j);
        sift_ahead(points.data() + first, extents == nullptr ? nullptr : extents + first, reach_m,
                   some);
        for (const Apart& apart : some) {
            look_at(~apart.by_two & 0b1111U, j, 2);
            look_at(~apart.by_three & 0b0101U, j, 3);
            j += Fan::width;
        }
    }
}

/// Levels are asked for in the order of the list; those between are passed over.
void Crowding::look_at_close(int piece, int level) {
    for (; !close_.empty(); close_ = close_.subspan(1)) {
        const auto& [own_level, nodes] = close_.front();
        if (nodes[0].piece > piece || (nodes[0].piece == piece && own_level < level)) return;
        if (nodes[0].piece < piece || own_level > level) continue;
        look_ahead(piece, level, nodes[0].index, nodes[1].index - nodes[0].index);
    }
}

void Crowding::look_ahead(int piece, int level, int j, int ahead) {
    const int count = curves_.segment_count(piece, level);
    const Piece& own = curves_.piece(piece);
    const bool is_closed = own.is_closed || own.next == piece;  // or a loop with one pin
    if (j + ahead >= count && !is_closed) return;
    const SegmentRef a{piece, j};
    const SegmentRef b{piece, (j + ahead) % count};
    if (are_settled(a, b, level)) return;
    if (overlap(box_at(a, level), box_at(b, level), reach_m_)) crowd(a, b, level);
}

/// Compares the nodes of two leaves of the hierarchy, or of one with each other.
void Crowding::between_roots(std::size_t a, std::size_t b) {
    const Stretch& roots_a = tree_.roots_[a];
    const Stretch& roots_b = tree_.roots_[b];
    for (int i = 0; i < roots_a.count; ++i) {
        for (int j = a == b ? i + 1 : 0; j < roots_b.count; ++j) {
            compare({roots_a.piece, roots_a.first + i}, {roots_b.piece, roots_b.first + j},
                    curves_.coarsest());
        }
    }
}

void Crowding::compare(SegmentRef a, SegmentRef b, int level) {
    if (are_neighbours(a, b, level)) {
        if (a.piece != b.piece) between_neighbours(a, b, level);
    } else {
        between_strangers(a, b, level);
    }
}

/// Compares the ends of two pieces that share a pin, at every level.
void Crowding::between_neighbours(SegmentRef a, SegmentRef b, int level) {
    if (level <= finest()) return;
    const Parts of_a = children(a, level);
    const Parts of_b = children(b, level);
    for (int i = 0; i < of_a.count; ++i) {
        for (int j = 0; j < of_b.count; ++j) compare(of_a.at[i], of_b.at[j], level - 1);
    }
}

void Crowding::between_strangers(SegmentRef a, SegmentRef b, int level) {
    if (left_ == 0 || are_settled(a, b, level)) return;
    --left_;
    if (overlap(box_at(a, level), box_at(b, level), reach_m_)) crowd(a, b, level);
}

/// For two nodes that are not neighbours and whose boxes meet: neither is alone, and their children
/// may meet.
void Crowding::crowd(SegmentRef a, SegmentRef b, int level) {
    if (is_pair_wanted()) {
        const bool is_either = level_of(a, level) == level || level_of(b, level) == level;
        if (level > 0 && is_either) meetings_.pairs.push_back({level, {{a, b}}});
    } else {
        mark(a, level);
        mark(b, level);
    }
    if (level <= finest()) return;
    const Parts of_a = children(a, level);
    const Parts of_b = children(b, level);
    for (int i = 0; i < of_a.count; ++i) {
        for (int j = 0; j < of_b.count; ++j) between_strangers(of_a.at[i], of_b.at[j], level - 1);
    }
    if (is_pair_wanted()) return;
    settle(a, level);
    settle(b, level);
}

int Crowding::level_of(SegmentRef a, int level) const {
    return std::min(level, curves_.piece(a.piece).coarsest);
}

SegmentRef Crowding::root_of(SegmentRef a, int level) const {
    return {a.piece, a.index >> (curves_.piece(a.piece).coarsest - level_of(a, level))};
}

/// Returns the nodes that replace it at the next finer level; level > 0.
Crowding::Parts Crowding::children(SegmentRef a, int level) const {
    if (level == 0 || level_of(a, level) < level) return {{a, a}, 1};
    const int first = 2 * a.index;
    const bool is_paired = first + 1 < curves_.segment_count(a.piece, level - 1);
    return {{{a.piece, first}, {a.piece, first + 1}}, is_paired ? 2 : 1};
}

bool Crowding::is_last(SegmentRef a, int level) const {
    return a.index + 1 == curves_.segment_count(a.piece, level_of(a, level));
}

bool Crowding::are_neighbours(SegmentRef a, SegmentRef b, int level) const {
    const auto follows = [&](SegmentRef before, SegmentRef after) {
        const Piece& piece = curves_.piece(before.piece);
        if (before.piece == after.piece && after.index == before.index + 1) return true;
        const int next = piece.is_closed ? before.piece : piece.next;
        return after.index == 0 && after.piece == next && is_last(before, level);
    };
    return follows(a, b) || follows(b, a);
}

std::size_t Crowding::node_at(SegmentRef a, int level) const {
    return curves_.first_point(a.piece, level_of(a, level)) + static_cast<std::size_t>(a.index);
}

Box Crowding::box_at(SegmentRef a, int level) const {
    return tree_.node_box(curves_, {a.piece, level_of(a, level), a.index});
}

/// Returns true if nothing is left to be found by comparing the two.
bool Crowding::are_settled(SegmentRef a, SegmentRef b, int level) const {
    return !is_pair_wanted() && settled_[node_at(a, level)] && settled_[node_at(b, level)];
}

void Crowding::mark(SegmentRef a, int level) {
    alone_.clear(node_at(a, level));
    if (level == 0) settled_[node_at(a, level)] = true;
}

/// The node is not alone; level > 0.
void Crowding::settle(SegmentRef a, int level) {
    const Parts parts = children(a, level);
    for (int i = 0; i < parts.count; ++i) {
        if (!settled_[node_at(parts.at[i], level - 1)]) return;
    }
    settled_[node_at(a, level)] = true;
}

SafeLevels find_safe_levels(const CurveSet& curves, const Meetings& meetings) {
    Changes changes(curves);
    if (!meetings.is_complete) changes.forbid_all();
    const MeetingNodes* first = meetings.pairs.data();
    const MeetingNodes* const end = first + meetings.pairs.size();
    while (first != end) {
        const MeetingNodes* last = std::find_if(
            first, end, [&](const MeetingNodes& pair) { return pair.level != first->level; });
        changes.look_at(first, last);
        first = last;
    }
    return std::move(changes).safe();
}

std::vector<PinPlace> pins_for(const CurveSet& curves, const SafeLevels& safe) {
    std::vector<PinPlace> pins;
    for (const UnsafeNode& unsafe : safe.unsafe) {
        const int piece = unsafe.node.piece;
        const int kept = safe.coarsest[static_cast<std::size_t>(piece)];
        if (unsafe.level != kept + 1) continue;
        const auto points = curves.points(piece, 0);
        const Segment s =
            curves.blend(piece, kept, 0.0)
                .segment(std::min(unsafe.node.index * 2, curves.segment_count(piece, kept) - 1));
        if (norm(s.b - s.a) >= fast_hand_spacing_m) continue;
        for (const int end : {unsafe.node.index, unsafe.node.index + 1}) {
            const auto i = static_cast<std::size_t>(end) << unsafe.level;
            const int outline = curves.piece(piece).outline;
            pins.push_back({outline, points[i < points.size() ? i : points.size() - 1]});
        }
    }
    return pins;
}

}  // namespace touchline
