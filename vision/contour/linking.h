// Joins separate edge lines to outlines: junctions, gaps, closing, the frame.
// Threads: pure function. O(n log n) in the points, if ends do not crowd.
#pragma once

#include "vision/contour/chain.h"

namespace touchline {

/// How far linking reaches, in working pixels.
struct Reach {
    double junction_px = 0.0;  // a line that ends this near another one meets it
    double gap_px = 0.0;       // breaks up to this are closed if both ends point at each other
    double blur_px = 0.0;      // near a junction the lines are bent over about this distance
    double shortest_px = 0.0;  // shorter lines attach to nothing
};

struct Linked {
    std::vector<Chain> chains;
    int gaps_closed = 0;
    int junctions = 0;
};

/// Joins lines, in this order:
/// * ends beside the frame are led to the frame (pixel edges, so -0.5 and size - 0.5);
/// * three or more ends within a junction's reach become one junction;
/// * ends that face each other across a gap are joined, cheapest first: cost = gap x (1 + bending
///   in radians), at most gap_px; a line's own two ends may be up to 5 % of its length apart;
/// * an end near another line (or further along its own) meets it there: a junction.
/// At a junction, arms that continue each other within 30 degrees run through as one outline;
/// others end there. All have the junction's point exactly, marked fixed. A line with both ends on
/// the frame is closed along it if the frame cuts off a shape.
[[nodiscard]] Linked linked(std::vector<Chain> lines, cv::Size picture, const Reach& reach);

}  // namespace touchline
