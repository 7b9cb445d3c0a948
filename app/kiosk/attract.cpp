#include "app/kiosk/attract.h"

#include "app/visit/proxy_radius.h"

#include <cmath>
#include <utility>

namespace touchline {
namespace {

constexpr double hand_m_per_s = 0.03;
constexpr double pressed_m = 0.001;  // past the line
constexpr double stiffness_N_per_m = 500.0;

double length_of(const CurveSet& curves, int piece) {
    double length_m = 0.0;
    for (int j = 0; j < curves.rendered_count(piece, 0.0); ++j) {
        const Segment segment = curves.rendered_segment(piece, 0.0, j);
        length_m += norm(segment.b - segment.a);
    }
    return length_m;
}

struct Longest {
    int piece = 0;
    double length_m = 0.0;
};

Longest longest_piece(const CurveSet& curves) {
    Longest longest;
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        const double length_m = length_of(curves, piece);
        if (length_m > longest.length_m) longest = {piece, length_m};
    }
    return longest;
}

/// The place on the segment, and a handle that is pressed a little past it.
HandState hand_on(const Segment& segment, double run_m) {
    const Direction ahead = direction_of(segment.b - segment.a);
    HandState hand;
    hand.p_WP = segment.a + along<Position>(ahead, run_m);
    hand.p_WH = hand.p_WP + along<Position>(left_of(ahead), pressed_m);
    hand.force = along<Force>(left_of(ahead), -stiffness_N_per_m * pressed_m);
    return hand;
}

}  // namespace

Result<ShownScene> attract_scene(const TactileMap& map) {
    auto scene = build_scene(map, CurveOptions{}, proxy_radius_m);
    if (!scene) return tl::unexpected(scene.error());
    return ShownScene{std::make_shared<const Scene>(std::move(*scene)), nullptr};
}

HandState attract_hand(const Scene& scene, double now_s) {
    const Longest longest = longest_piece(scene.curves);
    if (!(longest.length_m > 0.0)) return {};
    double left_m = std::fmod(hand_m_per_s * now_s, longest.length_m);
    const int count = scene.curves.rendered_count(longest.piece, 0.0);
    for (int j = 0; j < count; ++j) {
        const Segment segment = scene.curves.rendered_segment(longest.piece, 0.0, j);
        const double length_m = norm(segment.b - segment.a);
        if (left_m < length_m || j + 1 == count) return hand_on(segment, left_m);
        left_m -= length_m;
    }
    return {};
}

}  // namespace touchline
