// What a camera and a file do to a picture.
// Threads: pure functions.
#pragma once

#include <opencv2/core.hpp>

namespace touchline::testing {

struct Effects {
    double blur_px = 0.0;       // Gaussian sigma
    double noise_levels = 0.0;  // standard deviation, each channel on its own
    double shade = 0.0;         // the lower right corner is darker by this share of the light
    int jpeg_quality = 0;       // 0: no JPEG
    int seed = 1;
};

/// Applies shade, blur, noise, JPEG, in this order; 8-bit BGR in and out.
[[nodiscard]] cv::Mat seen(const cv::Mat& picture, const Effects& effects);

/// Returns one of six: clean, soft, noisy, shaded, JPEG, all of them mildly.
[[nodiscard]] Effects effects_of_kind(int kind, int seed);

}  // namespace touchline::testing
