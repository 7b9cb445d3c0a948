// The paper's interpolating biorthogonal wavelet transform ("pseudocoiflets", four vanishing
// moments; paper section 2) in lifting form: predicts each odd point from its even neighbours by
// the four-point Deslauriers-Dubuc rule (-1, 9, 9, -1)/16, and updates the evens with half the
// adjoint of that rule. Analysis low-pass = P (3 - 2P), with P the Deslauriers-Dubuc half-band
// filter: 13 taps. Denoises and compresses a curve by its details (paper sections 2 and 5).
// Threads: pure functions.
#pragma once

#include "config/types/vec2.h"

#include <cstddef>
#include <span>
#include <vector>

namespace touchline {

/// A curve at one level, and the details left out on the way from the next finer level.
struct WaveletLevel {
    std::vector<Position> points;  // scaling coefficients: the approximating polyline
    std::vector<Position>
        details;  // wavelet coefficients, one for each odd point of the finer level
};

/// How the points of a polyline are laid out. An open polyline of n segments has n + 1 points and
/// keeps its ends; a closed one has n points. An odd last segment passes up unpaired, as a shorter
/// segment.
struct CurveShape {
    std::size_t finest_segments = 0;  // at level 0: the parameter runs from 0 to this
    std::size_t stride = 1;  // 2^level: parameter of point i is min(i * stride, finest_segments)
    bool is_closed = false;
};

/// Returns the number of segments of the next coarser level: ceil(n / 2).
[[nodiscard]] constexpr std::size_t coarser_count(std::size_t segments) {
    return (segments + 1) / 2;
}

/// Makes one analysis step from the level with `shape` to the next coarser one. Reproduces cubics
/// in the parameter everywhere (details 0); the ends of an open curve stay where they are. O(n).
[[nodiscard]] WaveletLevel analyze(const std::vector<Position>& points, const CurveShape& shape);

/// The same into the caller's arrays: `coarser` holds coarser_count(n) points (open: one more) and
/// `details` n / 2, where n is the number of segments of the level with `shape`. The three arrays
/// must not overlap. O(n), allocates nothing.
void analyze(std::span<const Position> points, const CurveShape& shape, std::span<Position> coarser,
             std::span<Position> details);

/// Inverts analyze() up to rounding; `shape` is the finer level's. O(n).
[[nodiscard]] std::vector<Position> synthesize(const WaveletLevel& level, const CurveShape& shape);

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
