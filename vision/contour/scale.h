// Takes smoothing and thresholds from the picture itself: no constants in grey levels except the
// floor of an 8-bit picture.
// Threads: pure functions, O(pixels).
#pragma once

#include "vision/contour/edge_lines.h"

namespace touchline {

/// Returns the Gaussian sigma for edges, in pixels: as fine as the noise allows if large parts of
/// the picture are flat (drawings, logos, shapes), up to 2.5 px if nearly everything changes
/// (photos, in which finer edges are texture).
[[nodiscard]] double smoothing_for(const LabPicture& lab, double noise);

/// high = 0.45 x the 98th percentile of the gradient, at most 3 x the 75th; low = 0.4 high. Never
/// below six times what noise leaves in the gradient, nor below what rounding to 8 bits leaves.
[[nodiscard]] Hysteresis thresholds_for(const GradientField& field, double noise, double sigma_px);

/// 2 x the 75th percentile, without the floor: for a picture in which only its own grain can be
/// felt.
[[nodiscard]] Hysteresis grain_thresholds(const GradientField& field);

}  // namespace touchline
