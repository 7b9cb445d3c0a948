// The outlines as rendered at one level: a piece is looked up once for the many edges that the
// proxy visits there. Threads: one, the servo's.
#pragma once

#include "haptics/collision/scene.h"

#include <cstddef>

namespace touchline {

/// A rendered segment with its direction and length.
struct Edge {
    SegmentRef ref;
    Segment segment;
    Direction along;
    double length_m = 0.0;
    double per_length_m = 0.0;  // 1 / length; 0 where there is none
};

class RenderedOutlines {
  public:
    RenderedOutlines() = default;

    /// `scene` must outlive it.
    RenderedOutlines(const Scene& scene, double level) : scene_(&scene), level_(level) {}

    /// Precondition: made with a scene.
    [[nodiscard]] const Scene& scene() const { return *scene_; }

    [[nodiscard]] bool has_scene() const { return scene_ != nullptr; }

    [[nodiscard]] double level() const { return level_; }

    /// Some pieces may be blends of two levels.
    [[nodiscard]] bool is_fractional() const { return level_ != static_cast<int>(level_); }

    [[nodiscard]] Segment segment(SegmentRef ref) {
        look_up(ref.piece);
        return rendered_.segment(ref.index);
    }

    [[nodiscard]] Edge edge(SegmentRef ref) {
        const Segment s = segment(ref);
        const Position e = s.b - s.a;
        const double length = norm(e);
        if (!(length > 0.0)) return {ref, s, {1.0, 0.0}, 0.0, 0.0};
        const double per_length = 1.0 / length;
        return {ref, s, along<Direction>(e, per_length), length, per_length};
    }

    /// The segment after (before) one along its outline, across pins; piece -1 at an open end.
    [[nodiscard]] SegmentRef next(SegmentRef ref, bool is_forward) {
        look_up(ref.piece);
        const int index = ref.index + (is_forward ? 1 : -1);
        if (index >= 0 && index < rendered_.segment_count()) return {ref.piece, index};
        return is_forward ? scene_->curves.next(ref, level_) : scene_->curves.previous(ref, level_);
    }

    /// See CollisionTree::is_alone().
    [[nodiscard]] bool is_alone(SegmentRef ref) {
        look_up(ref.piece);
        return scene_->tree.is_alone(first_node_ + static_cast<std::size_t>(ref.index >> halves_));
    }

    /// A node is one rendered segment, not two blended halves.
    [[nodiscard]] bool is_whole(SegmentRef ref) {
        look_up(ref.piece);
        return halves_ == 0;
    }

  private:
    void look_up(int piece) {
        if (piece != piece_) [[unlikely]] {
            look_up_other(piece);
        }
    }

    [[gnu::noinline]] void look_up_other(int piece) {
        piece_ = piece;
        rendered_ = scene_->curves.rendered(piece, level_);
        const NodeRange nodes = CollisionTree::nodes(scene_->curves, piece, level_);
        first_node_ = nodes.first;
        halves_ = nodes.is_blend ? 1 : 0;
    }

    const Scene* scene_ = nullptr;
    double level_ = 0.0;
    int piece_ = -1;  // whose these are:
    RenderedPiece rendered_;
    std::size_t first_node_ = 0;
    int halves_ = 0;  // 1: a node holds two rendered segments
};

}  // namespace touchline
