// The curves that the bench works on: closed, 512 points at equal arc length, as in the paper's
// Fig. 3. Not cut at pins, so that every method has the same work. Threads: any.
#pragma once

#include "config/types/result.h"
#include "config/types/tactile_map.h"

#include <cstddef>
#include <string>
#include <vector>

namespace touchline::bench {

inline constexpr std::size_t outline_points = 512;

using ClosedCurve = std::vector<Position>;

/// The closed outlines of a map that are 40 mm long or more.
[[nodiscard]] std::vector<ClosedCurve> closed_outlines(const TactileMap& map);

/// Of every picture of the gallery: as drawn, or as the tracer finds them in its pixels.
[[nodiscard]] Result<std::vector<ClosedCurve>> gallery_outlines(bool is_traced);

/// Smooth closed curves of about 40 mm radius that are known exactly: two to five waves round.
[[nodiscard]] std::vector<ClosedCurve> smooth_outlines();

/// With Gaussian noise of standard deviation `sigma_m` on both coordinates; the same for the same
/// seed.
[[nodiscard]] ClosedCurve with_noise(const ClosedCurve& curve, double sigma_m, unsigned seed);

}  // namespace touchline::bench
