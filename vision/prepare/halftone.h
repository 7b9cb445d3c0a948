// Handles scanned pictures that were printed in dots.
// Threads: pure functions.
#pragma once

#include <opencv2/core.hpp>

namespace touchline {

/// Returns how far apart the dots of a printed picture are, pixels: 2.5 ... 16; 0 if it is not
/// printed in dots. Judged by the middle of the picture, at most 512 pixels square: two directions
/// at an angle share a quarter of everything that changes as fast, at the same pitch. 8-bit, BGR or
/// grey. About 10 ms.
[[nodiscard]] double dot_pitch(const cv::Mat& picture);

/// Returns the picture in the tones that its dots stand for; the same picture if it has none.
/// O(pixels).
[[nodiscard]] cv::Mat without_dots(const cv::Mat& picture);

}  // namespace touchline
