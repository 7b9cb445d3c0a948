// Turns gradients into sub-pixel lines by non-maximum suppression and hysteresis. Smoothing and
// thresholds come from the picture itself: no constants in grey levels except the floor of an 8-bit
// picture.
// Threads: pure functions.
#pragma once

#include "vision/contour/chain.h"
#include "vision/contour/gradient.h"

namespace touchline {

/// Thresholds on the gradient strength, grey levels per pixel: a line is followed while it is at
/// least `low`, and kept if it reaches `high` somewhere.
struct Hysteresis {
    double low = 0.0;
    double high = 0.0;
};

/// Returns the lines along which the gradient strength has a maximum across the edge: Canny's
/// definition (Canny 1986), solved as the zero crossings of the strength's slope along the normal,
/// cell by cell as in marching squares. So the points are sub-pixel, neighbours are known from the
/// cell that they share, and no thinning or pixel following is needed. A line ends where the
/// crossing does: at the threshold, at the frame, near a junction. Deterministic order (by first
/// row, column). O(pixels).
[[nodiscard]] std::vector<Chain> edge_lines(const GradientField& field, const Hysteresis& limits);

/// Returns the Gaussian sigma for edges, in pixels: as fine as the noise allows if large parts of
/// the picture are flat (drawings, logos, shapes), up to 2.5 px if nearly everything changes
/// (photos, in which finer edges are texture). O(pixels).
[[nodiscard]] double smoothing_for(const LabPicture& lab, double noise);

/// high = 0.45 x the 98th percentile of the gradient, at most 3 x the 75th; low = 0.4 high. Never
/// below six times what noise leaves in the gradient, nor below what rounding to 8 bits leaves.
/// O(pixels).
[[nodiscard]] Hysteresis thresholds_for(const GradientField& field, double noise, double sigma_px);

/// 2 x the 75th percentile, without the floor: for a picture in which only its own grain can be
/// felt.
[[nodiscard]] Hysteresis grain_thresholds(const GradientField& field);

/// Draws edge lines as a picture, to measure them against boundaries that people drew. O(points).
/// Returns an 8-bit picture: 255 r / (1 + r) on the pixels of the lines, else 0. r = mean strength
/// along 20 pixels either way / high x (1 - exp(-length / 30 px)): 128 is a long line exactly as
/// strong as `high`.
[[nodiscard]] cv::Mat edge_strength(const std::vector<Chain>& lines, cv::Size size, double high);

}  // namespace touchline
