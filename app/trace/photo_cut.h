// What a photograph and its previews share: the sides that the operator cuts off, and pixels in the
// program's own format. Threads: values and pure functions.
#pragma once

#include "app/decode/picture.h"

#include <opencv2/core.hpp>

namespace touchline {

/// The share that is cut off each side of a picture, in percent, 0 to 40; other numbers cut off
/// nothing.
struct PhotoCut {
    double left = 0.0;
    double right = 0.0;
    double top = 0.0;
    double bottom = 0.0;
};

/// The picture without the sides; at least one pixel stays. A view, no copy.
[[nodiscard]] cv::Mat cut_off(const cv::Mat& picture, const PhotoCut& cut);

/// 8-bit BGR as a picture. O(pixels).
[[nodiscard]] Picture picture_of(const cv::Mat& bgr);

}  // namespace touchline
