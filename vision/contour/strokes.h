// Finds lines drawn with a pen: drawings, handwriting, maps.
// Threads: pure function.
#pragma once

#include "vision/contour/chain.h"
#include "vision/contour/gradient.h"
#include "vision/prepare/paper.h"

namespace touchline {

/// A hand feels the two edges of a wider stroke.
inline constexpr double widest_stroke_mm = 3.0;

/// Returns the middle line of every stroke no wider than `greatest_width_px`, with its width
/// (width_px), and the outline of everything wider (width_px 0) and of every dot.
/// * Strokes stand out from the paper, whatever its colour and shade (prepare/paper.h).
/// * Sub-pixel: half-way between the two edges of the stroke.
/// * Bumps shorter than 0.8 widths are left out. Junctions within one width are one; there the
///   lines share their point bit for bit, fixed, and lines that continue each other within 30
///   degrees run through as one. A stroke that ends on a wide shape meets its outline.
/// * An end is half a width before the end of the ink, or on the frame; fixed.
/// * Corners are sharp and fixed.
/// noise: the picture's, grey levels (noise_of). Strength: of the stroke's edges, grey levels per
/// pixel. Deterministic. O(pixels), about 50 ms a megapixel.
[[nodiscard]] std::vector<Chain> stroke_lines(const LabPicture& lab, double noise,
                                              double greatest_width_px);

/// The same for ink that is already known.
[[nodiscard]] std::vector<Chain> stroke_lines(const Ink& ink, double greatest_width_px);

}  // namespace touchline
