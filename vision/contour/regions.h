// Finds the lines of pictures in flat colours: logos, diagrams, flags, clip art.
// Threads: pure function.
#pragma once

#include "vision/contour/chain.h"
#include "vision/contour/gradient.h"

namespace touchline {

/// Quantises the colours and gives every pixel to a region (region_map.h). Traces
/// strokes no wider than `greatest_width_px` by their middle lines, whatever their colours
/// (ink_parts.h, strokes.h), and the borders of all else (rings.h): one line per border,
/// not one from each side; sub-pixel, where the colour is half-way between the two; closed unless
/// the frame cuts it. A border ends on the stroke that it comes to. Where three regions meet, the
/// lines share their point bit for bit, fixed; lines that continue each other within 30 degrees run
/// through as one. Corners are sharp and fixed. Shapes cut off by the frame on one side are closed
/// along it. Strength: that of the step between the two colours, smoothed as edges are (grey levels
/// per pixel). noise: the picture's, grey levels (noise_of). Deterministic. O(pixels x colours),
/// about 120 ms a megapixel.
[[nodiscard]] std::vector<Chain> region_lines(const LabPicture& lab, double noise,
                                              double greatest_width_px);

}  // namespace touchline
