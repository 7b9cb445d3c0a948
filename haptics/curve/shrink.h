// Denoises and compresses a curve by its wavelet details (paper sections 2 and 5).
// Threads: pure functions.
#pragma once

#include "config/types/vec2.h"
#include "haptics/curve/wavelet.h"

#include <cstddef>
#include <span>
#include <vector>

namespace touchline {

/// A curve as its coarsest points and the details of every level; levels[k] leads from k + 1 to k.
struct Decomposition {
    std::vector<Position> coarsest;
    std::vector<std::vector<Position>> details;
    CurveShape shape;  // of level 0
};

[[nodiscard]] Decomposition decompose(std::vector<Position> points, const CurveShape& shape,
                                      int levels);

[[nodiscard]] std::vector<Position> reconstruct(const Decomposition& curve);

/// Returns the standard deviation of the details of each level, finest first, if the points of
/// level 0 carry white noise of standard deviation 1. The noise's covariance is taken through the
/// filters, which is exact except for the few details next to an open end (up to an eighth more
/// there). O(levels).
[[nodiscard]] std::vector<double> noise_gains(std::size_t levels);

/// Takes noise of standard deviation `noise_m` per coordinate out of the details of one level of a
/// curve of `count` points if noise is at least half of their energy; otherwise leaves them. A
/// detail d becomes (1 - t^2 / |d|^2) d, or 0 up to t: the garrote (Breiman 1995; Gao 1998) at the
/// universal threshold t = noise sqrt(2 ln count), which noise alone passes about once in a level.
/// O(n).
void denoise_level(std::span<Position> details, double noise_m, std::size_t count);

/// Takes white noise of standard deviation `sigma_m` per coordinate of level 0 out of every level.
/// The ends of an open curve stay where they are. O(N).
void denoise(Decomposition& curve, double sigma_m);

/// Returns the detail size (metres, scaled by its level so that sizes compare in energy) above
/// which the share `keep` of all the curves' details lies. 0 for keep >= 1.
[[nodiscard]] double detail_threshold(std::span<const Decomposition> curves, double keep);

/// Drops the details below the threshold of detail_threshold().
void drop_details(Decomposition& curve, double threshold_m);

}  // namespace touchline
