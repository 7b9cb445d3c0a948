#include "vision/prepare/page_light.h"

#include <array>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr int dark_level = 50;

}  // namespace

cv::Mat1b page_light(const cv::Mat& bgr, cv::Size size, double sigma_px) {
    cv::Mat small = bgr;
    if (bgr.size() != size) cv::resize(bgr, small, size, 0, 0, cv::INTER_AREA);
    cv::Mat channels[3];
    cv::split(small, channels);
    cv::Mat least;
    cv::min(channels[0], channels[1], least);
    cv::min(least, channels[2], least);
    cv::GaussianBlur(least, least, {}, sigma_px);
    return least;
}

int level_at(const cv::Mat1b& light, const cv::Mat1b& mask, double share) {
    std::array<int, 256> counts{};
    int total = 0;
    for (int y = 0; y < light.rows; ++y)
        for (int x = 0; x < light.cols; ++x) {
            if (mask(y, x) == 0) continue;
            ++counts[light(y, x)];
            ++total;
        }
    int level = 0;
    for (int below = counts[0]; level < 255 && below <= share * total;
         below += counts[static_cast<std::size_t>(level)])
        ++level;
    return level;
}

bool is_too_dark(const cv::Mat1b& light) {
    return level_at(light, cv::Mat1b(light.size(), std::uint8_t{255}), 0.95) < dark_level;
}

}  // namespace touchline
