// A map of colours as runs of pixels, by region. Flat pictures have few runs.
// Threads: pure function.
#pragma once

#include <vector>

#include <opencv2/core.hpp>

namespace touchline {

/// Pixels of one colour beside each other in a row.
struct Run {
    int row = 0;
    int from = 0;  // columns from ... to - 1
    int to = 0;
    std::size_t region = 0;  // index of the first run of the same 4-connected region
};

/// Row by row, from the left. O(pixels).
[[nodiscard]] std::vector<Run> runs_of(const cv::Mat1b& map);

}  // namespace touchline
