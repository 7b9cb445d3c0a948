// The curves that the bench works on: polylines of equal arc length; closed ones end on the point
// that they begin with. Threads: any.
#pragma once

#include "app/gallery/gallery.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"

#include <cstddef>
#include <string>
#include <vector>

namespace touchline::bench {

inline constexpr std::size_t outline_points = 512;  // of a closed outline, as in the paper's Fig. 3
inline constexpr std::size_t piece_segments = 128;

using Curve = std::vector<Position>;

/// The closed outlines of a map that are 40 mm long or more, whole.
[[nodiscard]] std::vector<Curve> closed_outlines(const TactileMap& map);

/// The stretches of a map between its pins, as the product cuts it, that are 20 mm long or more and
/// bend by 1 % of it.
[[nodiscard]] std::vector<Curve> pinned_pieces(const TactileMap& map);

/// The pictures that the bench measures: the gallery's first sixteen, so that its figures stay
/// comparable when the gallery grows.
[[nodiscard]] Result<std::vector<GalleryEntry>> measured_pictures();

/// Such curves of every picture that is measured: as drawn, or as the tracer finds them in its
/// pixels.
[[nodiscard]] Result<std::vector<Curve>> gallery_curves(
    bool is_traced, std::vector<Curve> (*curves_of)(const TactileMap&));

/// Smooth closed curves of about 40 mm radius that are known exactly: two to five waves round.
[[nodiscard]] std::vector<Curve> smooth_outlines();

/// With Gaussian noise of standard deviation `sigma_m` on both coordinates; the same for the same
/// seed.
[[nodiscard]] Curve with_noise(const Curve& curve, double sigma_m, unsigned seed);

}  // namespace touchline::bench
