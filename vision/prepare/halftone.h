// Pictures that were printed in dots, and scanned.
// Threads: pure functions.
#pragma once

#include <opencv2/core.hpp>

namespace touchline {

/// How far apart the dots of a printed picture stand, pixels: 2.5 ... 16; 0 where it is not printed
/// in dots. Judged by the middle of the picture, at most 512 pixels square: two directions at an
/// angle share a quarter of all that changes as fast, at the same pitch. 8-bit, BGR or grey. About
/// 10 ms.
[[nodiscard]] double dot_pitch(const cv::Mat& picture);

/// The picture in the tones that its dots stand for; the same where it has none. O(pixels).
[[nodiscard]] cv::Mat without_dots(const cv::Mat& picture);

}  // namespace touchline
