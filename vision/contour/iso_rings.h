// Where a smooth map takes one value: rings round all that lies above it.
// Threads: pure function, O(elements).
#pragma once

#include "vision/contour/chain.h"

namespace touchline {

/// Closed lines at `level`, linear between the elements' centres (marching squares), each once: one
/// round every area of elements >= level that touch by their sides, one round every hole in it.
/// Beyond the border everything counts as far below. Points are in elements, (column, row) at an
/// element's centre; higher values are to the right of the way (y down: areas clockwise).
[[nodiscard]] std::vector<Chain> iso_rings(const cv::Mat1f& values, float level);

/// Signed area within a ring, elements squared: positive where iso_rings runs round an area,
/// negative round a hole.
[[nodiscard]] double area_within(const Chain& ring);

}  // namespace touchline
