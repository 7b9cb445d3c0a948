#include "haptics/collision/scene.h"

#include "haptics/collision/collision_builder.h"
#include "haptics/collision/crowding.h"

#include <algorithm>
#include <compare>
#include <numeric>
#include <tuple>

namespace touchline {
namespace {

constexpr double label_reach_m = 0.01;

/// A vertex of level 0 where the hand rests for a label.
struct LabelStop {
    int piece = 0;
    int point = 0;
    int label = 0;

    friend auto operator<=>(const LabelStop&, const LabelStop&) = default;
};

std::vector<LabelStop> stops_of(const CurveSet& curves, const CollisionTree& tree,
                                std::span<const Label> labels) {
    std::vector<LabelStop> stops;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const Closest at = tree.closest_point(curves, labels[i].place, 0.0, label_reach_m);
        if (at.segment.piece < 0) continue;
        const int point = at.segment.index + (at.parameter < 0.5 ? 0 : 1);
        stops.push_back({at.segment.piece, point, static_cast<int>(i)});
    }
    std::ranges::sort(stops);
    return stops;
}

double length_m(std::span<const Position> points, int first, int last) {
    double sum_m = 0.0;
    for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i) {
        sum_m += norm(points[i + 1 == points.size() ? 0 : i + 1] - points[i]);
    }
    return sum_m;
}

std::vector<int> in_order(std::span<const Piece> pieces) {
    std::vector<int> order(pieces.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, {}, [&](int i) {
        const Piece& piece = pieces[static_cast<std::size_t>(i)];
        return std::tuple(piece.outline, piece.first_parameter);
    });
    return order;
}

/// `stops` are the piece's. One at its very start belongs to the leg that ended there.
void add_piece(const CurveSet& curves, int index, std::span<const LabelStop> stops,
               std::vector<Leg>& legs) {
    const auto pieces = curves.pieces();
    const Piece& piece = pieces[static_cast<std::size_t>(index)];
    const bool is_new = legs.empty() || legs.back().outline != piece.outline;
    const int end = curves.segment_count(index, 0);
    const bool is_corner =
        piece.next < 0 || pieces[static_cast<std::size_t>(piece.next)].starts_at_corner;
    int from = 0;
    const auto add = [&](int to, bool rests, int label) {
        legs.push_back({piece.outline, index, from, to, is_new && from == 0, rests, label,
                        length_m(curves.points(index, 0), from, to)});
        from = to;
    };
    int last_label = -1;
    for (const LabelStop& stop : stops) {
        if (stop.point == from) continue;
        if (stop.point >= end) {
            last_label = stop.label;
        } else {
            add(stop.point, true, stop.label);
        }
    }
    add(end, is_corner || last_label >= 0, last_label);
}

/// Turns lengths of legs into lengths up to the next rest.
void add_up_runs(std::vector<Leg>& legs) {
    for (std::size_t i = legs.size(); i-- > 0;) {
        const bool is_last = i + 1 == legs.size() || legs[i + 1].starts_outline;
        if (is_last) legs[i].rests_at_end = true;
        if (!legs[i].rests_at_end) legs[i].run_m += legs[i + 1].run_m;
    }
}

constexpr int most_builds = 2;  // pins move what is unsafe; what is left after that loses levels

Scene scene_of(CurveSet curves, CollisionTree tree, const TactileMap& map) {
    const int percept = percept_level(curves);
    std::vector<Leg> legs = legs_of(curves, tree, map.labels);
    return {std::move(curves), std::move(tree), map.area,   map.version,
            percept,           std::move(legs), map.drawing};
}

}  // namespace

std::vector<Leg> legs_of(const CurveSet& curves, const CollisionTree& tree,
                         std::span<const Label> labels) {
    const std::vector<LabelStop> stops = stops_of(curves, tree, labels);
    std::vector<Leg> legs;
    for (const int piece : in_order(curves.pieces())) {
        const auto own = std::ranges::equal_range(stops, piece, {}, &LabelStop::piece);
        add_piece(curves, piece, own, legs);
    }
    add_up_runs(legs);
    return legs;
}

Result<Scene> build_scene(const TactileMap& map, const CurveOptions& options, double radius_m) {
    const Result<CurveSource> source = CurveSource::read(map, options);
    if (!source) return tl::unexpected(source.error());
    std::vector<PinPlace> wanted = options.pins;
    KnownPieces known;
    for (int build = 1;; ++build) {
        Result<CurveSet> curves = source->build(wanted);
        if (!curves) return tl::unexpected(std::move(curves.error()));
        CollisionTreeBuilder builder(*curves, std::move(known));
        Meetings meetings = builder.find_meetings();
        const bool is_complete = meetings.is_complete;
        const SafeLevels safe = find_safe_levels(*curves, meetings);
        const auto pins = build < most_builds ? pins_for(*curves, safe) : std::vector<PinPlace>{};
        if (!pins.empty()) {
            wanted.insert(wanted.end(), pins.begin(), pins.end());
            // Else it depends on all pieces which details are dropped.
            known = options.keep_details < 1.0
                        ? KnownPieces{}
                        : std::move(builder).known_pieces(std::move(meetings));
            continue;
        }
        // Which nodes are alone depends on the levels that exist.
        const bool is_limited = !safe.unsafe.empty() || !is_complete;
        curves->limit_levels(safe.coarsest);
        if (is_limited) builder.hang();
        CollisionTree tree = std::move(builder).finish(radius_m);
        return scene_of(std::move(*curves), std::move(tree), map);
    }
}

}  // namespace touchline
