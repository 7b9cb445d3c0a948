#include "haptics/collision/safe_levels.h"

#include "haptics/collision/moving_wall.h"

#include <algorithm>

namespace touchline {
namespace {

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

    void forbid_all() { std::fill(safe_.coarsest.begin(), safe_.coarsest.end(), 0); }

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
        return std::any_of(one.begin(), one.end(), [&](const MovingSegment& a) {
            return std::any_of(other.begin(), other.end(), [&](const MovingSegment& b) {
                return passes_over(a, b) || passes_over(b, a);
            });
        });
    }

    /// Returns what the node holds on the way from `level` - 1 to `level`.
    [[nodiscard]] std::vector<MovingSegment> segments(SegmentRef node, int level) const {
        const bool is_moving = moves(node, level);
        const int finer = is_moving ? level - 1 : coarsest(node);
        const int own =
            std::min(level, curves_.pieces()[static_cast<std::size_t>(node.piece)].coarsest);
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

SafeLevels find_safe_levels(const CurveSet& curves, Meetings meetings) {
    Changes changes(curves);
    if (!meetings.is_complete) changes.forbid_all();
    auto& pairs = meetings.pairs;
    std::sort(pairs.begin(), pairs.end(), [](const MeetingNodes& a, const MeetingNodes& b) {
        return a.level != b.level ? a.level < b.level : a.nodes < b.nodes;
    });
    const MeetingNodes* first = pairs.data();
    const MeetingNodes* const end = first + pairs.size();
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
            const int outline = curves.pieces()[static_cast<std::size_t>(piece)].outline;
            pins.push_back({outline, points[i < points.size() ? i : points.size() - 1]});
        }
    }
    return pins;
}

}  // namespace touchline
