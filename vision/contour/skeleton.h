// Thins a shape to its middle line, pixel by pixel; the lines of the thinned shape, where they
// meet, and how they move from whole pixels to half-way between the stroke's edges. Threads: pure
// functions.
#pragma once

#include "vision/contour/chain.h"

#include <vector>

#include <opencv2/core.hpp>

namespace touchline {

/// Peels the mask (255 inside) from its edge inwards, the shallowest pixels first (depth: distance
/// to the edge), except every pixel that holds two parts together, surrounds a hole or is an end.
/// The rest is one pixel wide, 8-connected, in the middle of the strokes, with the parts and holes
/// of the mask; ends stop about half a stroke's width before the stroke does. (Distance ordered
/// homotopic thinning, Pudney 1998.) O(mask pixels).
[[nodiscard]] cv::Mat1b thinned(const cv::Mat1b& mask, const cv::Mat1f& depth);

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

/// Moves the points of a stroke's line half-way between the stroke's two edges, which are the
/// places across the line where `darkness` falls below 1. Then smooths by about a pixel, and sets
/// width_px, which must already be about right, to the median of the measured widths. Fixed points
/// stay, as do points less than a width from one, where strokes meet. A free end of an open line
/// moves to half a width before the end of the ink, or to the frame if the ink goes on that far,
/// and becomes fixed. O(points x width).
[[nodiscard]] Chain centred(const Chain& line, const cv::Mat1f& darkness);

/// The same without looking at its ends: for lines that have not been joined yet.
[[nodiscard]] Chain in_the_middle(const Chain& line, const cv::Mat1f& darkness);

}  // namespace touchline
