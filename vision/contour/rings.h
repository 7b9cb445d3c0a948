// Marching squares: rings where a smooth map takes one value, and the borders of a map of regions,
// both as sub-pixel lines. A ring that lies roughly round a thing can be drawn onto the thing's
// edge.
// Threads: pure functions.
#pragma once

#include "vision/contour/chain.h"
#include "vision/contour/gradient.h"

namespace touchline {

/// Returns closed lines at `level`, linear between the elements' centres (marching squares), each
/// once: one round every area of elements >= level that touch by their sides, one round every hole
/// in it. Beyond the border everything counts as far below. Points are in elements, (column, row)
/// at an element's centre; higher values are to the right of the way (y down: areas clockwise).
/// O(elements).
[[nodiscard]] std::vector<Chain> iso_rings(const cv::Mat1f& values, float level);

/// Returns the signed area within a ring, elements squared: positive if iso_rings runs round an
/// area, negative round a hole.
[[nodiscard]] double area_within(const Chain& ring);

/// Moves each point along its normal to the strongest edge within `reach_px`, preferring near ones;
/// then the median of seven neighbours decides. Points on the picture's frame stay. `strength` is
/// the gradient's, at pixel centres; the ring's points are about a pixel apart. O(points x reach).
void snap(Chain& ring, const cv::Mat1f& strength, double reach_px);

/// Returns the strength at the nearest pixel; 0 outside.
[[nodiscard]] float strength_at(const cv::Mat1f& strength, const cv::Point2d& at);

/// Returns whether a place is within a pixel of the picture's frame, or beyond it.
[[nodiscard]] bool is_on_frame(const cv::Point2d& at, cv::Size size);

/// The gradient of a step between flat colours over the step, per pixel: a Gaussian's peak, with a
/// sigma of about 1 px.
inline constexpr double gradient_over_step = 0.4;

/// Returns whether a ring holds a place; false on the ring itself. O(points).
[[nodiscard]] bool holds(const Chain& ring, const cv::Point2d& at);

/// Marching squares with any number of colours: a line crosses between two neighbouring pixels of
/// different colour where the picture is half-way from the one to the other, and runs from cell to
/// cell. A cell with three or four crossings that belong to three or four colours is a junction:
/// the lines end there in one fixed point, the same bit for bit; two colours in a checkerboard are
/// two lines that do not meet. So no line has a loose end except at the frame, none is doubled, and
/// none crosses another. In order of first row, column. O(pixels).
[[nodiscard]] std::vector<Chain> region_borders(const cv::Mat1b& map, const LabPicture& lab,
                                                const std::vector<cv::Vec3f>& palette);

}  // namespace touchline
