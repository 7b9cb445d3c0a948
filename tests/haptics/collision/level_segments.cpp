#include "tests/haptics/collision/level_segments.h"

#include "tests/exact/orientation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchline {

LevelSegments::LevelSegments(const CurveSet& curves, double level) {
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        first_of_piece_.push_back(all_.size());
        for (int j = 0; j < curves.rendered_count(piece, level); ++j) {
            all_.push_back({{piece, j}, curves.rendered_segment(piece, level, j)});
        }
    }
}

const Segment& LevelSegments::segment(SegmentRef ref) const {
    return all_[first_of_piece_[static_cast<std::size_t>(ref.piece)] +
                static_cast<std::size_t>(ref.index)]
        .segment;
}

std::optional<FirstMeeting> LevelSegments::first_meeting(Position from, Position to) const {
    const Position low{std::min(from.x, to.x), std::min(from.y, to.y)};
    const Position high{std::max(from.x, to.x), std::max(from.y, to.y)};
    std::optional<FirstMeeting> first;
    for (const auto& [ref, s] : all_) {
        const bool is_apart = std::max(s.a.x, s.b.x) < low.x || std::min(s.a.x, s.b.x) > high.x ||
                              std::max(s.a.y, s.b.y) < low.y || std::min(s.a.y, s.b.y) > high.y;
        if (is_apart) continue;
        const auto share = exact::first_meeting(from, to, s);
        if (share && (!first || *share < first->share)) first = {*share, ref};
    }
    return first;
}

bool LevelSegments::holds(Position p) const {
    return first_meeting(p, p).has_value();
}

bool LevelSegments::is_inside(Position p) const {
    bool is_odd = false;
    for (const auto& [ref, s] : all_) {
        if ((s.a.x <= p.x) == (s.b.x <= p.x)) continue;
        const bool is_rightward = s.a.x < s.b.x;
        const int side = exact::orientation(s.a, s.b, p);
        if (side == (is_rightward ? -1 : 1)) is_odd = !is_odd;  // p is below
    }
    return is_odd;
}

long double LevelSegments::distance_m(Position p) const {
    long double least = std::numeric_limits<long double>::infinity();
    for (const auto& [ref, s] : all_) least = std::min(least, touchline::distance_m(p, s));
    return least;
}

long double distance_m(Position p, const Segment& segment) {
    using Wide = long double;
    const Wide ex = Wide{segment.b.x} - segment.a.x;
    const Wide ey = Wide{segment.b.y} - segment.a.y;
    const Wide wx = Wide{p.x} - segment.a.x;
    const Wide wy = Wide{p.y} - segment.a.y;
    const Wide square = ex * ex + ey * ey;
    const Wide along = ex * wx + ey * wy;
    if (!(square > 0) || along <= 0) return std::hypot(wx, wy);
    if (along >= square) return std::hypot(Wide{p.x} - segment.b.x, Wide{p.y} - segment.b.y);
    return std::abs(ex * wy - ey * wx) / std::sqrt(square);
}

}  // namespace touchline
