#include "tests/vision/boundary/degraded.h"

#include "tests/vision/pictures/effects.h"

#include <cmath>

#include <opencv2/core.hpp>

namespace touchline::testing {
namespace {

cv::Mat with_gain(const cv::Mat& picture, double gain) {
    cv::Mat made;
    picture.convertTo(made, CV_8U, gain);
    return made;
}

cv::Mat with_gamma(const cv::Mat& picture, double gamma) {
    cv::Mat1b table(1, 256);
    for (int i = 0; i < 256; ++i) {
        table(i) = cv::saturate_cast<uchar>(255.0 * std::pow(i / 255.0, gamma));
    }
    cv::Mat made;
    cv::LUT(picture, table, made);
    return made;
}

}  // namespace

std::vector<Degraded> degraded(const cv::Mat& picture) {
    return {{"gain 0.6", with_gain(picture, 0.6)},
            {"gain 1.3", with_gain(picture, 1.3)},
            {"gamma 0.6", with_gamma(picture, 0.6)},
            {"50 % shade", seen(picture, {.shade = 0.5})},
            {"noise 5", seen(picture, {.noise_levels = 5.0})},
            {"JPEG 50", seen(picture, {.jpeg_quality = 50})},
            {"blur 1", seen(picture, {.blur_px = 1.0})}};
}

}  // namespace touchline::testing
