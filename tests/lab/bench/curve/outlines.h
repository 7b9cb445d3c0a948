// The curves that the bench works on: polylines of equal arc length; closed ones end on their first
// point. Threads: any.
#pragma once

#include "app/documents/gallery/gallery.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"

#include <cstddef>
#include <string>
#include <vector>

namespace touchline::bench {

inline constexpr std::size_t outline_points = 512;  // of a closed outline, as in the paper's Fig. 3
inline constexpr std::size_t piece_segments = 128;

using Curve = std::vector<Position>;

/// Returns the closed outlines of a map that are at least 40 mm long, whole.
[[nodiscard]] std::vector<Curve> closed_outlines(const TactileMap& map);

/// Returns the stretches of a map between its pins, as the product cuts it, that are at least 20 mm
/// long and bend by 1 % of that.
[[nodiscard]] std::vector<Curve> pinned_pieces(const TactileMap& map);

/// Returns the pictures that the bench measures: the gallery's first sixteen, so that its figures
/// stay comparable when the gallery grows.
[[nodiscard]] Result<std::vector<GalleryEntry>> measured_pictures();

/// Returns such curves of every measured picture: as drawn, or as the tracer finds them in its
/// pixels.
[[nodiscard]] Result<std::vector<Curve>> gallery_curves(
    bool is_traced, std::vector<Curve> (*curves_of)(const TactileMap&));

/// Returns smooth closed curves of about 40 mm radius that are known exactly: two to five waves
/// round.
[[nodiscard]] std::vector<Curve> smooth_outlines();

/// Adds Gaussian noise of standard deviation `sigma_m` to both coordinates; the same for the same
/// seed.
[[nodiscard]] Curve with_noise(const Curve& curve, double sigma_m, unsigned seed);

}  // namespace touchline::bench
