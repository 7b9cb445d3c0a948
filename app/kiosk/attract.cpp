#include "app/kiosk/attract.h"

#include "app/visit/proxy_radius.h"

#include <cmath>
#include <utility>

namespace touchline {
namespace {

constexpr double hand_m_per_s = 0.02;
constexpr double hand_step_s =
    1.0;  // each is a frame, and a frame is what a waiting kiosk pays for
constexpr double pressed_m = 0.001;  // past the line
constexpr double stiffness_N_per_m = 500.0;

std::vector<Segment> line_of(const CurveSet& curves, int piece) {
    std::vector<Segment> line;
    for (int j = 0; j < curves.rendered_count(piece, 0.0); ++j)
        line.push_back(curves.rendered_segment(piece, 0.0, j));
    return line;
}

double length_of(const std::vector<Segment>& line) {
    double length_m = 0.0;
    for (const Segment& segment : line) length_m += norm(segment.b - segment.a);
    return length_m;
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

Result<AttractPicture> attract_picture(const TactileMap& map) {
    auto scene = build_scene(map, CurveOptions{}, proxy_radius_m);
    if (!scene) return tl::unexpected(scene.error());
    AttractPicture picture;
    for (int piece = 0; piece < static_cast<int>(scene->curves.pieces().size()); ++piece) {
        std::vector<Segment> line = line_of(scene->curves, piece);
        const double length_m = length_of(line);
        if (!(length_m > picture.length_m)) continue;
        picture.line = std::move(line);
        picture.length_m = length_m;
    }
    picture.shown.scene = std::make_shared<const Scene>(std::move(*scene));
    return picture;
}

HandState attract_hand(const AttractPicture& picture, double now_s) {
    if (!(picture.length_m > 0.0)) return {};
    const double step_s = std::floor(now_s / hand_step_s) * hand_step_s;
    double left_m = std::fmod(hand_m_per_s * step_s, picture.length_m);
    for (const Segment& segment : picture.line) {
        const double length_m = norm(segment.b - segment.a);
        if (left_m < length_m || &segment == &picture.line.back()) return hand_on(segment, left_m);
        left_m -= length_m;
    }
    return {};
}

}  // namespace touchline
