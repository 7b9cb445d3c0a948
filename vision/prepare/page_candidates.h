// Finds places where a page might be, in two ways that fail on different pictures: bright regions
// (need a plain background) and straight lines (need straight sides, but not even light). Coarse:
// sides are right to within some pixels. Then judges whether a line is the side of a page: along
// it, paper on one side must be brighter than whatever lies on the other.
// Threads: pure functions.
#pragma once

#include "vision/prepare/quad.h"

#include <vector>

namespace touchline {

/// `light` is page_light() at some 0.1 megapixel. Corners may lie outside the picture, where its
/// frame cuts off a side. Returns at most some hundred, clockwise. O(pixels).
[[nodiscard]] std::vector<Quad> bright_regions(const cv::Mat1b& light);
[[nodiscard]] std::vector<Quad> line_quads(const cv::Mat1b& light);

/// The evidence along one side, from corner to corner.
struct SideEvidence {
    double visible = 0.0;   // share of it that lies in the picture
    double support = 0.0;   // share of the visible part that looks like a page's edge
    double contrast = 0.0;  // how much brighter it is inside, grey levels, at some distance
};

using QuadEvidence = std::array<SideEvidence, 4>;

/// Judges whether lines are the sides of a page. O(length), as are the next two.
/// `quad` is clockwise; side i runs from corner i to corner i + 1. A place counts as support if it
/// is brighter inside within two pixels of the line: quick, for many candidates. Leaves out
/// contrast.
[[nodiscard]] QuadEvidence rough_evidence(const cv::Mat1b& light, const Quad& quad);

/// A place counts as support if the steepest edge lies within `slack_px` of the line, while the
/// search for it reaches further: lines through a texture have equally good edges beside them.
[[nodiscard]] QuadEvidence exact_evidence(const cv::Mat1b& light, const Quad& quad,
                                          double slack_px);

/// Moves each side to the steepest edges within `reach_px` of it, by a line through them that
/// ignores strays; corners are where these cross. A side that is hardly in the picture stays.
/// Returns nothing if another side has too few edges.
[[nodiscard]] std::optional<Quad> refined(const cv::Mat1b& light, const Quad& quad,
                                          double reach_px);

}  // namespace touchline
