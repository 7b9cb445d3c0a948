#include "tests/lab/bench/contact/renderers.h"

#include "haptics/curve/segment.h"

namespace touchline::bench {

std::vector<Segment> edges_of(const CurveSet& curves) {
    std::vector<Segment> edges;
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        for (int j = 0; j < curves.rendered_count(piece, 0.0); ++j) {
            edges.push_back(curves.rendered_segment(piece, 0.0, j));
        }
    }
    return edges;
}

Felt Machine::step(Position hand) {
    const ContactReport report = machine_.step(hand, 0.0, settings_, {});
    return {report.force, report.p_WP};
}

Felt PlainProxy::step(Position hand) {
    const Position proxy = proxy_.step(hand);
    return {along<Force>(proxy - hand, wall_N_per_m), proxy};
}

Felt Penalty::step(Position hand) {
    Force sum;
    for (const Segment& edge : edges_) {
        const Foot at = foot(hand, edge);
        if (at.distance_m >= band_m_ || !(at.distance_m > 0.0)) continue;
        sum +=
            along<Force>(direction_of(hand - at.point), wall_N_per_m * (band_m_ - at.distance_m));
    }
    return {sum, hand};
}

}  // namespace touchline::bench
