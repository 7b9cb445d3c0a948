// Two pictures of one megapixel that are drawn by numbers, the same everywhere. Threads: pure
// functions.
#pragma once

#include <opencv2/core.hpp>

namespace touchline::bench {

/// Forty shapes on paper.
[[nodiscard]] cv::Mat drawing();

/// Clouds of four sizes and twelve discs of other clouds: nearly every pixel changes.
[[nodiscard]] cv::Mat photo();

}  // namespace touchline::bench
