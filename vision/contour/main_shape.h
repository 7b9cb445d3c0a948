// Finds the one thing that a photo shows, as a closed outline.
// Threads: pure function of its arguments, except that it sets OpenCV's random state of the calling
// thread (and restores it).
#pragma once

#include "vision/contour/chain.h"

#include <optional>

namespace touchline {

/// Returns the outline of what stands out from the border's colours, or of what is at `spot`
/// (pixels), in pixels of the picture (8-bit BGR). GrabCut (Rother 2004, two rounds) cuts a copy of
/// at most 160 pixels a side, seeded by how much a pixel differs from the border's colours, nearer
/// the middle first. The largest part becomes a ring, drawn onto the strongest edge nearby at a
/// finer copy. Holes are filled. Returns nothing if no shape convinces: one smaller than 2 % or
/// larger than 70 % of the picture, mostly cut off by the frame, like the rest in colour, or with
/// too weak an edge. Strength: grey levels per pixel of the finer copy. Deterministic. About 150
/// ms, whatever the size.
[[nodiscard]] std::optional<Chain> main_shape(const cv::Mat& picture,
                                              std::optional<cv::Point2d> spot);

}  // namespace touchline
