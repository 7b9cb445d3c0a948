// The one thing that a photo shows, as a closed outline.
// Threads: pure function of its arguments, but it sets OpenCV's random state of the calling thread
// (and puts it back).
#pragma once

#include "vision/contour/chain.h"

#include <optional>

namespace touchline {

/// The outline of what stands out from the border's colours, or of what is at `spot` (pixels), in
/// pixels of the picture (8-bit BGR). A copy of at most 160 pixels a side is cut by GrabCut
/// (Rother 2004, two rounds), seeded by how unlike the border's colours a pixel is, nearer the
/// middle first; the largest part becomes a ring, drawn onto the strongest edge nearby at a finer
/// copy. Holes are filled. Nothing if no shape convinces: smaller than 2 % or larger than 70 % of
/// the picture, mostly cut off by the frame, not unlike the rest in colour, or with too weak an
/// edge. Strength: grey levels per pixel of the finer copy. Deterministic. About 150 ms, whatever
/// the size.
[[nodiscard]] std::optional<Chain> main_shape(const cv::Mat& picture,
                                              std::optional<cv::Point2d> spot);

}  // namespace touchline
