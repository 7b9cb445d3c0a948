#include "haptics/contact/rendered_outlines.h"

namespace touchline {

void RenderedOutlines::look_up_piece(int piece) {
    piece_ = piece;
    rendered_ = scene_->curves.rendered(piece, level_);
    const NodeRange nodes = CollisionTree::nodes(scene_->curves, piece, level_);
    first_node_ = nodes.first;
    halves_ = nodes.is_blend ? 1 : 0;
    row_ = {{}, nodes.first};
    if (is_fractional_) return;  // a neighbour may be a blend, which alone says less of
    const double level = scene_->curves.rendered_level(piece, level_);
    row_.points = scene_->curves.points(piece, static_cast<int>(level));
}

void RenderedOutlines::look_up_edge(SegmentRef ref) {
    const Segment s = segment(ref);
    const Position e = s.b - s.a;
    const double length = norm(e);
    const double per_length = length > 0.0 ? 1.0 / length : 0.0;
    const Direction along_it = length > 0.0 ? along<Direction>(e, per_length) : Direction{1.0, 0.0};
    edge_ = {ref, s, along_it, length, per_length};
    ahead_ = behind_ = Openness::unknown;
}

/// Open only if both are whole segments of their levels: for a blend, "alone" says less.
RenderedOutlines::Openness RenderedOutlines::openness(bool is_forward) {
    if (is_fractional() || !is_alone(edge_.ref)) return Openness::closed;
    const SegmentRef neighbour = next(edge_.ref, is_forward);
    if (neighbour.piece < 0) return Openness::open;
    const Segment s = segment(neighbour);
    return dot(edge_.along, s.b - s.a) >= 0.0 ? Openness::open : Openness::closed;
}

}  // namespace touchline
