#include "tests/haptics/collision/meetings.h"

#include "tests/exact/orientation.h"

#include <cmath>
#include <vector>

namespace touchline::trials {
namespace {

struct Rendered {
    int piece, span;  // the node that holds it
    int spans;        // of the piece
    Segment segment;
};

std::vector<Rendered> rendered(const CurveSet& curves, double level) {
    std::vector<Rendered> all;
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        const double own = curves.rendered_level(piece, level);
        const bool is_blend = own > std::floor(own);
        const RenderedPiece at = curves.rendered(piece, level);
        const int spans = curves.segment_count(piece, static_cast<int>(std::ceil(own)));
        for (int j = 0; j < at.segment_count(); ++j) {
            all.push_back({piece, is_blend ? j / 2 : j, spans, at.segment(j)});
        }
    }
    return all;
}

bool are_neighbours(const CurveSet& curves, const Rendered& a, const Rendered& b) {
    const auto follows = [&](const Rendered& before, const Rendered& after) {
        const Piece& piece = curves.pieces()[static_cast<std::size_t>(before.piece)];
        const int next = piece.is_closed ? before.piece : piece.next;
        const bool is_over = before.span + 1 == before.spans && after.span == 0;
        return (before.piece == after.piece && before.span + 1 == after.span) ||
               (is_over && after.piece == next);
    };
    const bool is_same = a.piece == b.piece && a.span == b.span;
    return is_same || follows(a, b) || follows(b, a);
}

}  // namespace

int meetings(const CurveSet& curves, double level) {
    const std::vector<Rendered> all = rendered(curves, level);
    int met = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = i + 1; j < all.size(); ++j) {
            if (are_neighbours(curves, all[i], all[j])) continue;
            const Segment& s = all[i].segment;
            const Segment& t = all[j].segment;
            met += exact::meet(s.a, s.b, t.a, t.b) ? 1 : 0;
        }
    }
    return met;
}

int levels_with_meetings(const CurveSet& curves) {
    int levels = 0;
    for (double level = 0.0; level <= curves.coarsest(); level += 0.0625) {
        levels += meetings(curves, level) > 0 ? 1 : 0;
    }
    return levels;
}

}  // namespace touchline::trials
