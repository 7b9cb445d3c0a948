// Denoising and compression of a curve by its wavelet details (paper sections 2 and 5).
// Threads: pure functions.
#pragma once

#include "config/types/vec2.h"
#include "haptics/curve/wavelet.h"

#include <cstddef>
#include <span>
#include <vector>

namespace touchline {

/// A curve as its coarsest points and the details of every level, levels[k] leading from k + 1 to
/// k.
struct Decomposition {
    std::vector<Position> coarsest;
    std::vector<std::vector<Position>> details;
    CurveShape shape;  // of level 0
};

[[nodiscard]] Decomposition decompose(std::vector<Position> points, const CurveShape& shape,
                                      int levels);

[[nodiscard]] std::vector<Position> reconstruct(const Decomposition& curve);

/// Shrinks every detail towards 0 by the universal threshold of white noise with standard deviation
/// `sigma_m` per coordinate: sigma sqrt(2 ln N), times what the filters make of it on each level.
void denoise(Decomposition& curve, double sigma_m);

/// The detail size (metres, scaled by its level so that sizes compare in energy) above which the
/// share `keep` of all details of the curves lies. 0 for keep >= 1.
[[nodiscard]] double detail_threshold(std::span<const Decomposition> curves, double keep);

/// Drops the details below the threshold of detail_threshold().
void drop_details(Decomposition& curve, double threshold_m);

}  // namespace touchline
