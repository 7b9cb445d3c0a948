// Finds where a smooth map takes one value: rings round everything above it.
// Threads: pure function, O(elements).
#pragma once

#include "vision/contour/chain.h"

namespace touchline {

/// Returns closed lines at `level`, linear between the elements' centres (marching squares), each
/// once: one round every area of elements >= level that touch by their sides, one round every hole
/// in it. Beyond the border everything counts as far below. Points are in elements, (column, row)
/// at an element's centre; higher values are to the right of the way (y down: areas clockwise).
[[nodiscard]] std::vector<Chain> iso_rings(const cv::Mat1f& values, float level);

/// Returns the signed area within a ring, elements squared: positive if iso_rings runs round an
/// area, negative round a hole.
[[nodiscard]] double area_within(const Chain& ring);

}  // namespace touchline
