#include "haptics/curve/curve_set.h"

#include <algorithm>
#include <cmath>

namespace touchline {

std::span<const Position> CurveSet::points(int piece, int level) const {
    const Level& at =
        levels_[first_level_[static_cast<std::size_t>(piece)] + static_cast<std::uint32_t>(level)];
    return {points_.data() + at.first, at.count};
}

int CurveSet::segment_count(int piece, int level) const {
    const auto count = static_cast<int>(points(piece, level).size());
    return pieces_[static_cast<std::size_t>(piece)].is_closed ? count : count - 1;
}

double CurveSet::rendered_level(int piece, double level) const {
    return std::min(level, static_cast<double>(pieces_[static_cast<std::size_t>(piece)].coarsest));
}

int CurveSet::rendered_count(int piece, double level) const {
    return segment_count(piece, static_cast<int>(rendered_level(piece, level)));
}

Position CurveSet::rendered_point(int piece, double level, int i) const {
    const double rendered = rendered_level(piece, level);
    const auto finer = static_cast<int>(rendered);
    const double weight = rendered - finer;
    const auto fine = points(piece, finer);
    const Position p = fine[static_cast<std::size_t>(i)];
    if (!(weight > 0.0)) return p;
    const auto coarse = points(piece, finer + 1);
    const auto half = static_cast<std::size_t>(i) / 2;
    const bool is_unpaired_end = !pieces_[static_cast<std::size_t>(piece)].is_closed &&
                                 i + 1 == static_cast<int>(fine.size());
    Position q = is_unpaired_end ? coarse.back() : coarse[half];
    if (i % 2 != 0 && !is_unpaired_end) q = 0.5 * (q + coarse[(half + 1) % coarse.size()]);
    return p + weight * (q - p);  // in this form a pin stays exactly where it is
}

Segment CurveSet::rendered_segment(int piece, double level, int j) const {
    const int count = rendered_count(piece, level);
    const bool wraps = pieces_[static_cast<std::size_t>(piece)].is_closed && j + 1 == count;
    return {rendered_point(piece, level, j), rendered_point(piece, level, wraps ? 0 : j + 1)};
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
    const auto stride = std::exp2(std::floor(rendered_level(piece, level)));
    const double length = segment_count(piece, 0);
    const double from = stride * j;
    const double to = std::min(from + stride, length);
    return pieces_[static_cast<std::size_t>(piece)].first_parameter + from + t * (to - from);
}

}  // namespace touchline
