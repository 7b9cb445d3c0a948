// What can be seen of a picture that another program painted, and what of it is felt, by the edges
// of its colours. Lengths are millimetres at the hand. Threads: pure functions.
#pragma once

#include "tests/app/drawings/felt.h"

#include <vector>

#include <opencv2/core.hpp>

namespace touchline::bench {

/// Places where a hand may expect a line, at truth_px_per_mm, as masks: 8 bit, 255 there.
struct PictureTruth {
    cv::Mat edges;  // where colours meet
    cv::Mat lines;  // these, and the middles of strokes up to testing::widest_line_mm

    /// Where an edge pixel may be felt: there, or in the middle of the stroke on either side. At a
    /// stroke's corners and ends no side is opposite, and the middle is somewhere within
    /// `beside_px`.
    struct Edge {
        std::vector<cv::Point> choices;
        float beside_px = 0.0F;
    };

    std::vector<Edge> each;
};

inline constexpr double truth_px_per_mm = 10.0;

/// Returns the truth of an 8-bit picture of 3 channels, fitted on the sheet. Its own border is not
/// an edge. O(pixels).
[[nodiscard]] PictureTruth truth_of(const cv::Mat& picture);

/// The share of the edges that is felt within the tolerance, and the share of the felt lines that
/// is seen. Edges beside each other, within `gap_mm`, count once one of them is felt.
struct Shares {
    testing::Counted seen;
    testing::Counted felt;
};

[[nodiscard]] Shares shares_of(const PictureTruth& truth, const TactileMap& map, double gap_mm,
                               double tolerance_mm);

/// Whether the edges of both pictures lie within the tolerance of each other, to 99 of 100.
[[nodiscard]] bool are_alike(const PictureTruth& a, const PictureTruth& b, double tolerance_mm);

}  // namespace touchline::bench
