#include "app/screen/marks.h"

#include "app/screen/rendered_path.h"
#include "app/screen/shape_marks.h"

#include <algorithm>

namespace touchline {

void add_outlines(Strokes& strokes, const View& view, const CurveSet& curves, double level,
                  double width_px, const Palette& palette) {
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        const auto path = rendered_path(curves, piece, level, view);
        for (std::size_t i = 1; i < path.size(); ++i)
            strokes.add_line(path[i - 1], path[i], width_px, {palette.outline});
    }
}

void add_boxes(Strokes& strokes, const View& view, std::span<const ErrorBox> boxes,
               double width_px) {
    for (const ErrorBox& box : boxes) {
        for (std::size_t i = 0; i < box.corners.size(); ++i)
            strokes.add_line(view.to_px(box.corners[i]),
                             view.to_px(box.corners[(i + 1) % box.corners.size()]), width_px,
                             {white_on_black.box});
    }
}

void add_hand(Strokes& strokes, const View& view, const HandState& hand, double proxy_radius_m,
              double unit_px, const Palette& palette) {
    constexpr double arrow_units_per_N = 40.0;
    const PixelPoint handle = view.to_px(hand.p_WH);
    const PixelPoint proxy = view.to_px(hand.p_WP);
    const double px_per_N = arrow_units_per_N * unit_px;
    const PixelPoint reach{px_per_N * hand.force.x, -px_per_N * hand.force.y};
    const double disc_px = std::max(view.px_per_m * proxy_radius_m, 2.5 * unit_px);
    if (hand.shape == HeldShape::none) strokes.add_dot(proxy, disc_px, {palette.proxy});
    add_shape(strokes, view, hand, unit_px, palette);
    strokes.add_line(handle, proxy, unit_px, {palette.handle});
    strokes.add_ring(handle, 5.0 * unit_px, 2.5 * unit_px, {palette.background});
    strokes.add_ring(handle, 5.0 * unit_px, 1.25 * unit_px, {palette.handle});
    strokes.add_arrow(handle, handle + reach, 1.5 * unit_px, {palette.force});
}

}  // namespace touchline
