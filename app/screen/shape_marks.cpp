#include "app/screen/shape_marks.h"

#include "haptics/probe/held_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace touchline {
namespace {

constexpr double arc_units = 22.0;  // the arc's radius
constexpr double rad_per_Nm = 2.0 * std::numbers::pi / 3.0 / 15e-3;
constexpr double most_arc_rad = 1.6 * std::numbers::pi;
constexpr double step_rad = 0.1;

void add_edges(Strokes& strokes, const View& view, const ProbeShape& shape, const ProbePose& pose,
               double width_px, const Paint& paint) {
    const ProbePlacement placed(pose);
    const bool is_round = shape.edges().size() == 1;
    for (const Segment& edge : shape.edges()) {
        const PixelPoint a = view.to_px(placed(edge.a));
        if (is_round)
            strokes.add_ring(a, view.px_per_m * shape.radius_m(), width_px, paint);
        else
            strokes.add_line(a, view.to_px(placed(edge.b)), width_px, paint);
    }
}

void add_torque(Strokes& strokes, PixelPoint centre, double torque_Nm, double unit_px,
                const Paint& paint) {
    const double reach_rad = std::clamp(rad_per_Nm * torque_Nm, -most_arc_rad, most_arc_rad);
    if (!(std::abs(reach_rad) > step_rad)) return;
    // Starts above the handle; y points down on the screen.
    const auto at = [&](double turned_rad) {
        const double angle_rad = std::numbers::pi / 2.0 + turned_rad;
        const double radius_px = arc_units * unit_px;
        return centre +
               PixelPoint{radius_px * std::cos(angle_rad), -radius_px * std::sin(angle_rad)};
    };
    const int steps = static_cast<int>(std::ceil(std::abs(reach_rad) / step_rad));
    for (int i = 1; i < steps; ++i) {
        strokes.add_line(at(reach_rad * (i - 1) / steps), at(reach_rad * i / steps), 1.5 * unit_px,
                         paint);
    }
    strokes.add_arrow(at(reach_rad * (steps - 1) / steps), at(reach_rad), 1.5 * unit_px, paint);
}

}  // namespace

void add_shape(Strokes& strokes, const View& view, const HandState& hand, double unit_px,
               const Palette& palette) {
    if (hand.shape == HeldShape::none) return;
    const ProbeShape shape = held_shape(hand.shape);
    const ProbePose wanted{hand.p_WH.x, hand.p_WH.y, hand.angle_rad};
    const ProbePose held{hand.p_WP.x, hand.p_WP.y, hand.proxy_angle_rad};
    add_edges(strokes, view, shape, wanted, unit_px, {palette.handle});
    if (!hand.is_shape_placed) return;
    add_edges(strokes, view, shape, held, 2.5 * unit_px, {palette.proxy});
    add_torque(strokes, view.to_px(hand.p_WH), hand.torque_Nm, unit_px, {palette.force});
}

}  // namespace touchline
