// The outlines as rendered at one level. Looks a piece up once for the many edges that the proxy
// visits there, and an edge once for the many steps that it stays on it. Threads: one, the servo's.
#pragma once

#include "haptics/collision/scene.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace touchline {

/// A rendered segment with its direction and length.
struct Edge {
    SegmentRef ref;
    Segment segment;
    Direction along;
    double length_m = 0.0;
    double per_length_m = 0.0;  // 1 / length; 0 where there is none
};

/// The edges of one piece at a whole level: edge j lies between points j and j + 1.
struct EdgeRow {
    std::span<const Position> points;  // empty at a fractional level
    std::size_t first_node = 0;        // of the collision tree, of edge 0
};

inline constexpr double largest_octaves = 0.5;  // of a change of level under the hand, in a tick

/// Returns `level`, or the whole level next to `from` on the way there: up to that level every
/// point of the curves moves in a straight line.
[[nodiscard]] inline double within_octave(double from, double level) {
    return level > from ? std::min(level, std::floor(from) + 1.0)
                        : std::max(level, std::ceil(from) - 1.0);
}

/// Beside a node at a level that is blended lie two nodes of two segments each.
inline constexpr int halves_beside = 3;

/// Calls visit(segment) for each segment within `reached` of the given ones along the outline, by
/// next(segment, is_forward), without these themselves; for some twice.
template <class Next, class Visit>
void visit_beside(const std::array<SegmentRef, 2>& own, int reached, const Next& next,
                  const Visit& visit) {
    for (const SegmentRef& start : own) {
        for (const bool is_forward : {true, false}) {
            SegmentRef at = start;
            for (int i = 0; i < reached && at.piece >= 0; ++i) {
                at = next(at, is_forward);
                if (at.piece >= 0 && at != own[0] && at != own[1]) visit(at);
            }
        }
    }
}

class RenderedOutlines {
  public:
    RenderedOutlines() = default;

    /// `scene` must outlive it.
    RenderedOutlines(const Scene& scene, double level)
        : scene_(&scene), level_(level), is_fractional_(level != std::floor(level)) {}

    /// Precondition: made with a scene.
    [[nodiscard]] const Scene& scene() const { return *scene_; }

    [[nodiscard]] bool has_scene() const { return scene_ != nullptr; }

    [[nodiscard]] double level() const { return level_; }

    /// True if some pieces may be blends of two levels.
    [[nodiscard]] bool is_fractional() const { return is_fractional_; }

    [[nodiscard]] Segment segment(SegmentRef ref) {
        look_up(ref.piece);
        return rendered_.segment(ref.index);
    }

    /// The result is valid until the next edge is asked for.
    [[nodiscard]] const Edge& edge(SegmentRef ref) {
        if (ref != edge_.ref) look_up_edge(ref);
        return edge_;
    }

    /// Whether a slide towards the edge's end (start) that stops short of it can meet nothing: the
    /// edge is alone, and the next one does not run back beside it.
    [[nodiscard]] bool is_open(SegmentRef ref, bool is_forward) {
        if (ref != edge_.ref) look_up_edge(ref);
        Openness& known = is_forward ? ahead_ : behind_;
        if (known == Openness::unknown) known = openness(is_forward);
        return known == Openness::open;
    }

    [[nodiscard]] const EdgeRow& row(int piece) {
        look_up(piece);
        return row_;
    }

    /// Whether the segment exists.
    [[nodiscard]] bool has(SegmentRef ref) const {
        const auto pieces = scene_->curves.piece_count();
        return ref.piece >= 0 && ref.piece < pieces && ref.index >= 0 &&
               ref.index < scene_->curves.rendered_count(ref.piece, level_);
    }

    /// Returns the segment after (before) `ref` along its outline, across pins and over segments
    /// that are points, which an outline that runs back on itself has at coarse levels. Piece -1 at
    /// an open end.
    [[nodiscard]] SegmentRef next(SegmentRef ref, bool is_forward) {
        SegmentRef found = neighbour(ref, is_forward);
        while (found.piece >= 0 && found != ref && is_point(segment(found))) [[unlikely]] {
                found = neighbour(found, is_forward);
            }
        return found;
    }

    /// See CollisionTree::is_alone().
    [[nodiscard]] bool is_alone(SegmentRef ref) {
        look_up(ref.piece);
        return scene_->tree.is_alone(first_node_ + static_cast<std::size_t>(ref.index >> halves_));
    }

  private:
    [[nodiscard]] SegmentRef neighbour(SegmentRef ref, bool is_forward) {
        look_up(ref.piece);
        const int index = ref.index + (is_forward ? 1 : -1);
        if (index >= 0 && index < rendered_.segment_count()) return {ref.piece, index};
        return is_forward ? scene_->curves.next(ref, level_) : scene_->curves.previous(ref, level_);
    }

    void look_up(int piece) {
        if (piece != piece_) [[unlikely]] {
            look_up_piece(piece);
        }
    }

    void look_up_piece(int piece);
    void look_up_edge(SegmentRef ref);

    enum class Openness : std::uint8_t { unknown, open, closed };

    [[nodiscard]] Openness openness(bool is_forward);

    const Scene* scene_ = nullptr;
    double level_ = 0.0;
    bool is_fractional_ = false;
    int piece_ = -1;  // whose these are:
    RenderedPiece rendered_;
    std::size_t first_node_ = 0;
    int halves_ = 0;  // 1: a node holds two rendered segments
    EdgeRow row_;
    Edge edge_;                           // the last one asked for
    Openness ahead_ = Openness::unknown;  // of it
    Openness behind_ = Openness::unknown;
};

}  // namespace touchline
