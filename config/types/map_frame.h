// The one place where millimetres of a map's viewBox and metres of the picture frame W meet. vision
// puts its points on the grid here, and app/documents/decode writes and reads them here, so that a
// traced map and the same map read back from its SVG hold the same bits. Threads: pure functions.
// Everything is O(1).
#pragma once

#include "config/types/tactile_map.h"
#include "config/types/vec2.h"

#include <cmath>

namespace touchline {

/// The viewBox of a map SVG: the drawing area in millimetres, x right, y down. Sizes > 0.
struct ViewBox {
    double x0_mm = 0.0;
    double y0_mm = 0.0;
    double width_mm = 0.0;
    double height_mm = 0.0;

    friend bool operator==(const ViewBox&, const ViewBox&) = default;
};

/// A point in a viewBox.
struct ViewBoxPoint {
    double u_mm = 0.0;
    double v_mm = 0.0;

    friend bool operator==(const ViewBoxPoint&, const ViewBoxPoint&) = default;
};

/// Returns the nearest multiple of 1e-6 mm: one nanometre, far below any encoder, and at most six
/// decimals when written. For |value| up to a metre, the result is the double that those decimals
/// read as.
[[nodiscard]] inline double on_nanometre_grid_mm(double value_mm) noexcept {
    return std::round(value_mm * 1e6) / 1e6;
}

/// Returns the viewBox that a map of this area is written with: `0 0 width height`, sizes on the
/// grid.
[[nodiscard]] inline ViewBox view_box_of(const Area& area) noexcept {
    return {0.0, 0.0, on_nanometre_grid_mm(area.width_m * 1000.0),
            on_nanometre_grid_mm(area.height_m * 1000.0)};
}

/// Returns the drawing area of a viewBox. area_of(view_box_of(a)) is a fixed point of the pair.
[[nodiscard]] inline Area area_of(const ViewBox& box) noexcept {
    return {box.width_mm / 1000.0, box.height_mm / 1000.0};
}

/// Returns the point (u, v) of a viewBox in W. Exactly these expressions in this order: a reader
/// and a writer that agree on u and v agree on every bit of W.
[[nodiscard]] inline Position from_view_box(double u_mm, double v_mm, const ViewBox& box) noexcept {
    return {(u_mm - box.x0_mm - box.width_mm / 2.0) / 1000.0,
            (box.y0_mm + box.height_mm / 2.0 - v_mm) / 1000.0};
}

/// Inverts from_view_box(). A coordinate whose grid value leads back to the very same bits comes
/// back on the grid, as all canonical points do; any other comes back unrounded, within a few ulp.
[[nodiscard]] inline ViewBoxPoint to_view_box(Position point, const ViewBox& box) noexcept {
    const ViewBoxPoint exact{point.x * 1000.0 + box.width_mm / 2.0 + box.x0_mm,
                             box.y0_mm + box.height_mm / 2.0 - point.y * 1000.0};
    const ViewBoxPoint grid{on_nanometre_grid_mm(exact.u_mm), on_nanometre_grid_mm(exact.v_mm)};
    const Position back = from_view_box(grid.u_mm, grid.v_mm, box);
    return {back.x == point.x ? grid.u_mm : exact.u_mm, back.y == point.y ? grid.v_mm : exact.v_mm};
}

/// Returns the point (u, v) of the viewBox of an area, moved onto the nanometre grid, in W. Every
/// point of a map made here is stored in this form.
[[nodiscard]] inline Position canonical_point(double u_mm, double v_mm, const Area& area) noexcept {
    return from_view_box(on_nanometre_grid_mm(u_mm), on_nanometre_grid_mm(v_mm), view_box_of(area));
}

}  // namespace touchline
