// What a photograph and its previews share: the sides that the operator leaves out, and pixels that
// are the program's own. Threads: values and pure functions.
#pragma once

#include "app/decode/picture.h"

#include <opencv2/core.hpp>

namespace touchline {

/// So much of every picture is left out at its sides, percent, 0 to 40 each; other numbers leave
/// out nothing.
struct PhotoCut {
    double left = 0.0;
    double right = 0.0;
    double top = 0.0;
    double bottom = 0.0;
};

/// Without the sides; a pixel stays at least. A view, no copy.
[[nodiscard]] cv::Mat cut_off(const cv::Mat& picture, const PhotoCut& cut);

/// 8-bit BGR as a picture. O(pixels).
[[nodiscard]] Picture picture_of(const cv::Mat& bgr);

}  // namespace touchline
