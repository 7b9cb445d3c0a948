// What a camera and a file do to a picture, and changes that must not alter its lines.
// Threads: pure functions.
#pragma once

#include <string>
#include <vector>

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

struct Degraded {
    std::string name;
    cv::Mat picture;
};

/// Returns the picture at 0.6 and 1.3 times its light, with gamma 0.6, shaded by half, with noise
/// of 5 grey levels, as JPEG of quality 50, and blurred by 1 px. 8-bit BGR, all of one size.
[[nodiscard]] std::vector<Degraded> degraded(const cv::Mat& picture);

}  // namespace touchline::testing
