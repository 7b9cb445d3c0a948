// Joins lines: separate edges to outlines, dashes and dots in a row, which a hand takes as one
// line, and the two edges of a narrow stripe (a pole, a pen stroke, a branch). Threads: pure
// functions.
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
/// the frame is closed along it if the frame cuts off a shape. O(n log n) in the points, if ends do
/// not crowd.
[[nodiscard]] Linked linked(std::vector<Chain> lines, cv::Size picture, const Reach& reach);

/// Joins dashes (short open lines, up to 7 mm) and dots (small rings, up to 3 mm across) into one
/// line through them, LineOf::dashed or LineOf::dotted, if they follow one another in one course,
/// at gaps of at most 4.2 mm, and are alike in length and in gaps. The line is closed if the last
/// leads to the first. It takes three dashes or five dots. Dots that lie in a field, letters that
/// are not alike, and more than 2000 pieces stay. Lengths in pixels: `mm_px` is a millimetre.
/// O(pieces squared in the worst case, else of those near each other).
[[nodiscard]] std::vector<Chain> with_dashes_joined(std::vector<Chain> lines, double mm_px);

/// Merges two lines less than `widest_px` apart into one in the middle if they face each other with
/// opposite light (both sides of a dark stripe are lighter, of a light one darker) along more than
/// 70 % of the shorter one. `width_px` is their mean distance if the stripe is most of the line,
/// else 0. A ring that faces itself in this way becomes an open line. The shorter line's other
/// stretches are dropped, unless they continue the longer one beyond its end; the longer line's
/// stay. A line is merged once, the narrowest pairs first. Fixed points move with their line, as do
/// those of other lines that share them. Lines whose light side is not known stay as they are.
/// Lines that are not merged keep their order. O(points x points within reach).
[[nodiscard]] std::vector<Chain> with_double_edges_merged(std::vector<Chain> chains,
                                                          cv::Size picture, double widest_px);

}  // namespace touchline
