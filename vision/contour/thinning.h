// Thins a shape to its middle line, pixel by pixel.
// Threads: pure function.
#pragma once

#include <opencv2/core.hpp>

namespace touchline {

/// Peels the mask (255 inside) from its edge inwards, the shallowest pixels first (depth: distance
/// to the edge), except every pixel that holds two parts together, surrounds a hole or is an end.
/// The rest is one pixel wide, 8-connected, in the middle of the strokes, with the parts and holes
/// of the mask; ends stop about half a stroke's width before the stroke does. (Distance ordered
/// homotopic thinning, Pudney 1998.) O(mask pixels).
[[nodiscard]] cv::Mat1b thinned(const cv::Mat1b& mask, const cv::Mat1f& depth);

}  // namespace touchline
