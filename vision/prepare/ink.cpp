#include "vision/prepare/ink.h"

#include "vision/prepare/paper.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr double kLeastContrast = 12.0;
constexpr double kContrastOverNoise = 2.0;
constexpr double kContrastOverInk = 0.22;  // fainter than this beside the ink is dirt and shadow
constexpr double kInkPart = 0.002;         // this part of the picture is darker than "the ink"
constexpr int kAround_px = 9;              // where a stroke's own darkest point is looked for
constexpr double kSmoothing_px = 0.7;

cv::Mat1f contrast_to(const LabPicture& lab, const Paper& paper) {
    cv::Mat1f contrast(lab.size());
    std::vector<cv::Vec3f> colours;
    for (int row = 0; row < lab.rows; ++row) {
        paper.fill_row(row, colours);
        for (int column = 0; column < lab.cols; ++column) {
            const cv::Vec3f d = lab(row, column) - colours[static_cast<std::size_t>(column)];
            contrast(row, column) = std::sqrt(d.dot(d));
        }
    }
    return contrast;
}

}  // namespace

double least_contrast(double noise, double strongest) {
    return std::max({kLeastContrast, kContrastOverNoise * noise, kContrastOverInk * strongest});
}

Ink ink_of(const LabPicture& lab, double noise) {
    LabPicture calm = lab;
    if (noise > 1.0) {  // first: the distance of noise to the paper is never 0
        cv::GaussianBlur(lab, calm, cv::Size(), kSmoothing_px);
    }
    const Paper paper(lab);
    Ink ink;
    ink.paper_part = paper.part();
    ink.contrast = contrast_to(calm, paper);
    const auto strong = static_cast<double>(quantile(ink.contrast, 1.0 - kInkPart));
    ink.floor = least_contrast(noise, strong);

    cv::Mat1f half;
    cv::dilate(ink.contrast, half, cv::Mat::ones(kAround_px, kAround_px, CV_8U));
    cv::blur(half, half, {kAround_px, kAround_px});
    half = cv::max(0.5 * half, ink.floor);
    cv::divide(ink.contrast, half, ink.darkness);
    ink.mask = cv::Mat(ink.darkness >= 1.0F);
    return ink;
}

}  // namespace touchline
