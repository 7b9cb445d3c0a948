#include "vision/prepare/page_light.h"

#include "vision/contour/gradient.h"
#include "vision/prepare/paper.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr int dark_level = 50;

constexpr double looked_at_pixels = 60e3;  // the surface is smooth: a small copy shows all of it
constexpr float ink_share = 0.36F;
constexpr double paper_level = 235.0;
constexpr double least_level = 12.0;  // of paper in deep shade; darker is not made brighter for it

/// Paper in a shade of 60 % is still brighter than 0.4 of the brightest. Anything much darker is
/// ink and must not be taken for the commonest colour, although it may cover half the page.
void silence_ink(cv::Mat3f& picture) {
    cv::Mat1f levels;
    cv::extractChannel(picture, levels, 1);
    cv::Mat1b rounded;
    levels.convertTo(rounded, CV_8U);
    const auto bright =
        static_cast<float>(level_at(rounded, cv::Mat1b(rounded.size(), std::uint8_t{255}), 0.95));
    for (int y = 0; y < picture.rows; ++y)
        for (int x = 0; x < picture.cols; ++x)
            if (levels(y, x) < ink_share * bright) picture(y, x) = no_paper(x, y);
}

/// Returns the paper's colour at every pixel of a small copy. The surface is fitted to blue, green
/// and red directly: light multiplies them, and its steps are as smooth there as in Lab.
cv::Mat3f paper_of(const cv::Mat& bgr) {
    cv::Mat3f small;
    reduced(bgr, looked_at_pixels).convertTo(small, CV_32FC3);
    silence_ink(small);
    const Paper paper(small);
    std::vector<cv::Vec3f> row;
    for (int y = 0; y < small.rows; ++y) {
        paper.fill_row(y, row);
        std::copy(row.begin(), row.end(), small[y]);
    }
    return small;
}

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

cv::Mat evenly_lit(const cv::Mat& bgr) {
    const cv::Mat paper = cv::max(paper_of(bgr), cv::Scalar::all(least_level));
    cv::Mat gain;
    cv::divide(paper_level, paper, gain, CV_32F);
    cv::resize(gain, gain, bgr.size(), 0, 0, cv::INTER_LINEAR);
    cv::Mat out;
    cv::multiply(bgr, gain, out, 1.0, CV_8U);
    return out;
}

}  // namespace touchline
