// Edge detectors to measure. Each makes a strength map of a picture, 128 where its own automatic
// rule would draw the line, as `touchline trace --edges` does.
// Threads: one.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace touchline::bench {

struct Detector {
    std::string name;
    std::string setting;
    /// Maps 8-bit BGR to what the automatic rule keeps (this is timed).
    std::function<cv::Mat1b(const cv::Mat&)> automatic;
    /// Returns the same with strengths, to be swept. For a rule that only says yes or no: the
    /// greatest multiple m of its threshold that keeps the pixel, as 255 m / (1 + m).
    std::function<cv::Mat1b(const cv::Mat&)> ranked;
};

[[nodiscard]] std::vector<Detector> detectors();

}  // namespace touchline::bench
