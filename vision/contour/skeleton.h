// The lines of a thinned shape, and where they meet.
// Threads: pure function.
#pragma once

#include "vision/contour/ends.h"

#include <vector>

namespace touchline {

/// Arms run from node to node, from node to free end, or round (closed). Their points are pixel
/// centres, with the node's place first and last; not fixed.
struct Skeleton {
    std::vector<Chain> arms;
    std::vector<std::vector<EndId>> nodes;  // the ends that meet, two or more each
};

/// Returns the arms of a thinned mask. depth: distance to the shape's edge; it tells how wide the
/// stroke is.
/// * A free arm shorter than 0.8 stroke widths at its node is a bump of the edge, and left out.
/// * Nodes less than one stroke width apart are one node (a crossing thins to two).
/// * Loops shorter than a stroke width are left out.
/// Deterministic, in order of first row, column. O(mask pixels).
[[nodiscard]] Skeleton skeleton_of(const cv::Mat1b& thin, const cv::Mat1f& depth);

}  // namespace touchline
