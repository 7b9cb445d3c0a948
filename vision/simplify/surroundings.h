// Where a line lies in the whole: on the outside, inside something, or along the picture's frame;
// lines joined over small breaks, and round a thing where others meet them. Chains here are in
// millimetres of the drawing area.
// Threads: pure functions.
#pragma once

#include "vision/contour/chain.h"

#include <vector>

#include <opencv2/core.hpp>

namespace touchline {

/// A break up to this long is closed: a groove must not end by accident.
inline constexpr double small_break_mm = 4.0;

/// Joins free ends that are nearer than `reach_mm` and point at each other, cheapest first: cost =
/// distance x (1 + bending in radians), at most 70 degrees at each end (any bending under a quarter
/// of the reach). A line closes on itself if it is longer than four times the break. Ends that
/// other lines share (junctions) are not free. O(n log n + pairs near).
[[nodiscard]] std::vector<Chain> with_breaks_closed(std::vector<Chain> lines, double reach_mm);

/// What a disc of 1.5 mm can reach from outside the area; it does not get in through a smaller
/// break in the outer line. Lines under 15 mm hide nothing. O(area / 0.25 mm^2 + points).
class Outside {
  public:
    Outside(const std::vector<Chain>& lines, cv::Size2d area_mm);

    /// Returns the share of a line's points, 0..1, that the outside reaches. O(points).
    [[nodiscard]] double share_of(const Chain& line) const;

    [[nodiscard]] std::vector<double> shares_of(const std::vector<Chain>& lines) const;

    /// Returns the share that it reaches from both sides: high for a line that stands out by
    /// itself, while one that goes round a thing has the outside on one side. O(points).
    [[nodiscard]] double share_on_both_sides(const Chain& line) const;

  private:
    cv::Mat1f to_outside_;  // cells
};

/// Returns whether a line is the picture's own frame: nine tenths of it lie within 4 % of the
/// shorter side of the picture's edges, along at least three of them.
[[nodiscard]] bool is_frame(const Chain& line, const cv::Rect2d& picture_mm);

/// Returns whether the ink of a frame reaches the picture's edges: the rim of its ground, or of the
/// sheet.
[[nodiscard]] bool is_rim(const Chain& line, const cv::Rect2d& picture_mm);

/// Returns whether one of the others ends on this line, within a millimetre. O(points x others).
[[nodiscard]] bool is_met(const Chain& line, const std::vector<Chain>& others);

/// Returns the area that a closed line holds, square millimetres; 0 for an open one. O(points).
[[nodiscard]] double held_area(const Chain& line);

/// If just two of the arms where lines meet have the outside on one side, and all others lie within
/// the thing, those two become one: arcs that lead into a thing become one ring round it. A
/// junction with an arm that stands out (the outside is on both of its sides) stays as it is.
/// O(points log points).
[[nodiscard]] std::vector<Chain> with_silhouettes_joined(std::vector<Chain> lines,
                                                         const Outside& outside);

}  // namespace touchline
