#include "app/screen/marks.h"

#include "haptics/probe/probe_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace touchline {
namespace {

std::uint8_t byte_of(double share) {
    return static_cast<std::uint8_t>(std::lround(255.0 * share));
}

/// A polygon that nobody tells from a circle.
PixelLine ring(PixelPoint centre, double radius_px) {
    constexpr int parts = 24;
    PixelLine line;
    for (int i = 0; i <= parts; ++i) {
        const double angle_rad = 2.0 * std::numbers::pi * i / parts;
        line.push_back(
            centre + PixelPoint{radius_px * std::cos(angle_rad), radius_px * std::sin(angle_rad)});
    }
    return line;
}

void add_line(Strokes& strokes, const PixelLine& line, double width_px, const Paint& paint) {
    strokes.add({&line, 1}, width_px, paint);
}

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
            add_line(strokes, ring(a, view.px_per_m * shape.radius_m()), width_px, paint);
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
    PixelLine arc;
    for (int i = 0; i < steps; ++i) arc.push_back(at(reach_rad * i / steps));
    add_line(strokes, arc, 1.5 * unit_px, paint);
    strokes.add(arrow(arc.back(), at(reach_rad), 1.5 * unit_px), 1.5 * unit_px, paint);
}

}  // namespace

PixelLine rendered_path(const CurveSet& curves, int piece, double level, const View& view) {
    constexpr double least_px = 2.0;
    PixelLine path;
    const int segments = curves.rendered_count(piece, level);
    for (int j = 0; j < segments; ++j) {
        const Segment segment = curves.rendered_segment(piece, level, j);
        if (path.empty()) path.push_back(view.to_px(segment.a));
        const PixelPoint end = view.to_px(segment.b);
        if (j + 1 == segments || norm(end - path.back()) >= least_px) path.push_back(end);
    }
    return path;
}

std::vector<PixelLine> arrow(PixelPoint from, PixelPoint to, double width_px) {
    if (!(norm(to - from) >= 1.0)) return {};
    const double head_px = 4.0 * width_px;
    const Direction ahead = direction_of(to - from);
    const PixelPoint back = to - along<PixelPoint>(ahead, head_px);
    const PixelPoint aside = along<PixelPoint>(left_of(ahead), 0.6 * head_px);
    return {{from, to, back + aside}, {to, back - aside}};
}

std::vector<PixelLine> force_arrow(PixelPoint from, const Force& force, double px_per_N,
                                   double width_px) {
    const PixelPoint reach{px_per_N * force.x, -px_per_N * force.y};  // y points down on the screen
    return arrow(from, from + reach, width_px);
}

void Strokes::add_line(PixelPoint a, PixelPoint b, double width_px, const Paint& paint) {
    if (!is_finite(a) || !is_finite(b)) return;
    const double length = norm(b - a);
    const Direction ahead = direction_of(b - a);
    const double half = width_px / 2.0;
    const double reach = half + 1.0;  // room for the smooth rim
    const std::array<std::uint8_t, 4> rgba{byte_of(paint.colour.red), byte_of(paint.colour.green),
                                           byte_of(paint.colour.blue), byte_of(paint.alpha)};
    const auto corner = [&](double along_px, double across_px) {
        const PixelPoint p =
            a + along<PixelPoint>(ahead, along_px) + along<PixelPoint>(left_of(ahead), across_px);
        vertices_.push_back({static_cast<float>(p.x), static_cast<float>(p.y),
                             static_cast<float>(along_px), static_cast<float>(across_px),
                             static_cast<float>(length), static_cast<float>(half), rgba});
    };
    corner(-reach, -reach);
    corner(length + reach, -reach);
    corner(length + reach, reach);
    corner(-reach, -reach);
    corner(length + reach, reach);
    corner(-reach, reach);
}

void Strokes::add(std::span<const PixelLine> lines, double width_px, const Paint& paint) {
    for (const PixelLine& line : lines)
        for (std::size_t i = 1; i < line.size(); ++i)
            add_line(line[i - 1], line[i], width_px, paint);
}

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

void add_outlines(Strokes& strokes, const View& view, const CurveSet& curves, double level,
                  double width_px, const Palette& palette) {
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        add_line(strokes, rendered_path(curves, piece, level, view), width_px, {palette.outline});
    }
}

void add_boxes(Strokes& strokes, const View& view, std::span<const ErrorBox> boxes, double width_px,
               const Palette& palette) {
    for (const ErrorBox& box : boxes) {
        PixelLine edges;
        for (const Position& corner : box.corners) edges.push_back(view.to_px(corner));
        edges.push_back(edges.front());
        add_line(strokes, edges, width_px, {palette.box});
    }
}

void add_pen(Strokes& strokes, const View& view, std::span<const Position> stroke_W,
             double width_px, const Palette& palette) {
    constexpr double least_px = 2.0;
    PixelLine line;
    for (const Position& p_W : stroke_W) {
        const PixelPoint at = view.to_px(p_W);
        if (line.empty() || norm(at - line.back()) >= least_px) line.push_back(at);
    }
    if (line.size() == 1) line.push_back(line.front());
    add_line(strokes, line, width_px, {palette.pen});
}

void add_hand(Strokes& strokes, const View& view, const HandState& hand, double proxy_radius_m,
              double unit_px, const Palette& palette) {
    constexpr double arrow_units_per_N = 40.0;
    const PixelPoint handle = view.to_px(hand.p_WH);
    const PixelPoint proxy = view.to_px(hand.p_WP);
    const double disc_px = std::max(view.px_per_m * proxy_radius_m, 2.5 * unit_px);
    if (hand.shape == HeldShape::none)
        strokes.add_line(proxy, proxy, 2.0 * disc_px, {palette.proxy});
    add_shape(strokes, view, hand, unit_px, palette);
    strokes.add_line(handle, proxy, unit_px, {palette.handle});
    const PixelLine handle_ring = ring(handle, 5.0 * unit_px);
    add_line(strokes, handle_ring, 2.5 * unit_px, {palette.background});
    add_line(strokes, handle_ring, 1.25 * unit_px, {palette.handle});
    strokes.add(force_arrow(handle, hand.force, arrow_units_per_N * unit_px, 1.5 * unit_px),
                1.5 * unit_px, {palette.force});
}

}  // namespace touchline
