// What the picture itself says about smoothing and thresholds: no constants in grey levels but the
// floor of an 8-bit picture.
// Threads: pure functions, O(pixels).
#pragma once

#include "vision/contour/edge_lines.h"

namespace touchline {

/// Gaussian sigma for edges, in pixels: as fine as the noise allows where large parts of the
/// picture are flat (drawings, logos, shapes), up to 2.5 px where nearly everything changes
/// (photos, where finer edges are texture).
[[nodiscard]] double smoothing_for(const LabPicture& lab, double noise);

/// high = 0.45 x the 98th percentile of the gradient, at most 3 x the 75th; low = 0.4 high. Never
/// below six times what noise leaves in the gradient, nor below what rounding to 8 bits leaves.
[[nodiscard]] Hysteresis thresholds_for(const GradientField& field, double noise, double sigma_px);

/// 2 x the 75th percentile, without the floor: for a picture in which nothing but its own grain can
/// be felt.
[[nodiscard]] Hysteresis grain_thresholds(const GradientField& field);

}  // namespace touchline
