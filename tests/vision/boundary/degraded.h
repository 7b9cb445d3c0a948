// Changes that must not alter the lines of a picture.
// Threads: pure functions.
#pragma once

#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace touchline::testing {

struct Degraded {
    std::string name;
    cv::Mat picture;
};

/// Returns the picture at 0.6 and 1.3 times its light, with gamma 0.6, shaded by half, with noise
/// of 5 grey levels, as JPEG of quality 50, and blurred by 1 px. 8-bit BGR, all of one size.
[[nodiscard]] std::vector<Degraded> degraded(const cv::Mat& picture);

}  // namespace touchline::testing
