#include "haptics/curve/curve_set.h"

#include <algorithm>
#include <cmath>

namespace touchline {

Position RenderedPiece::blended_point(int i) const {
    const Position p = fine_[i];
    const bool is_open = segment_count_ < fine_count_;
    const bool is_unpaired_end = is_open && i + 1 == fine_count_;
    const int half = i / 2;
    Position q = coarse_[is_unpaired_end ? coarse_count_ - 1 : half];
    if (i % 2 != 0 && !is_unpaired_end) {
        q = 0.5 * (q + coarse_[half + 1 == coarse_count_ ? 0 : half + 1]);
    }
    return p + weight_ * (q - p);  // in this form a pin stays exactly where it is
}

RenderedPiece CurveSet::rendered(int piece, double level) const {
    const double at = rendered_level(piece, level);
    return blend(piece, static_cast<int>(at), at - static_cast<int>(at));
}

RenderedPiece CurveSet::blend(int piece, int finer, double weight) const {
    const int coarsest = pieces_[static_cast<std::size_t>(piece)].coarsest;
    finer = std::min(finer, coarsest);
    const Level& fine = level_of(piece, finer);
    RenderedPiece view;
    view.fine_ = points_.data() + fine.first;
    view.fine_count_ = static_cast<int>(fine.count);
    view.segment_count_ =
        view.fine_count_ - (pieces_[static_cast<std::size_t>(piece)].is_closed ? 0 : 1);
    view.weight_ = finer < coarsest ? weight : 0.0;
    if (view.weight_ > 0.0) {
        const Level& coarse = level_of(piece, finer + 1);
        view.coarse_ = points_.data() + coarse.first;
        view.coarse_count_ = static_cast<int>(coarse.count);
    }
    return view;
}

void CurveSet::limit_levels(std::span<const int> coarsest) {
    coarsest_ = 0;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        pieces_[i].coarsest = std::min(pieces_[i].coarsest, coarsest[i]);
        coarsest_ = std::max(coarsest_, pieces_[i].coarsest);
    }
}

int CurveSet::rendered_count(int piece, double level) const {
    return segment_count(piece, static_cast<int>(rendered_level(piece, level)));
}

SegmentRef CurveSet::next(SegmentRef segment, double level) const {
    const Piece& piece = pieces_[static_cast<std::size_t>(segment.piece)];
    if (segment.index + 1 < rendered_count(segment.piece, level)) {
        return {segment.piece, segment.index + 1};
    }
    if (piece.is_closed) return {segment.piece, 0};
    return piece.next >= 0 ? SegmentRef{piece.next, 0} : SegmentRef{};
}

SegmentRef CurveSet::previous(SegmentRef segment, double level) const {
    const Piece& piece = pieces_[static_cast<std::size_t>(segment.piece)];
    if (segment.index > 0) return {segment.piece, segment.index - 1};
    if (piece.is_closed) return {segment.piece, rendered_count(segment.piece, level) - 1};
    if (piece.previous < 0) return {};
    return {piece.previous, rendered_count(piece.previous, level) - 1};
}

double CurveSet::outline_parameter(int piece, double level, int j, double t) const {
    const double stride = 1 << static_cast<int>(rendered_level(piece, level));
    const double length = segment_count(piece, 0);
    const double from = stride * j;
    const double to = std::min(from + stride, length);
    return pieces_[static_cast<std::size_t>(piece)].first_parameter + from + t * (to - from);
}

}  // namespace touchline
