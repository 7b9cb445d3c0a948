#include "vision/contour/regions.h"

#include "vision/contour/corners.h"
#include "vision/contour/linking.h"
#include "vision/contour/palette.h"
#include "vision/contour/region_borders.h"
#include "vision/contour/region_map.h"
#include "vision/prepare/paper.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr double kLeastPart = 0.001;  // of the picture: a smaller region is a speck
constexpr double kLeastPaper = 0.3;   // less, and the paper says nothing about the light
constexpr double kPictureBlur_px = 0.7;
constexpr double kCalm = 1.0;  // grey levels of noise that need no smoothing

/// Sigma that brings noise down to a grey level or two, but rounds no corner by a pixel.
double smoothing_for_noise(double noise) {
    constexpr double kGreatest_px = 1.5;
    return noise > kCalm ? std::min(kGreatest_px, 0.5 + 0.1 * noise) : 0.0;
}

Reach reach_of_borders() {
    Reach reach;  // all ends meet already; only the frame is near
    reach.junction_px = 0.5;
    reach.gap_px = 0.5;
    reach.blur_px = 0.8;
    return reach;
}

}  // namespace

std::vector<Chain> region_lines(const LabPicture& lab, double noise) {
    const double smoothing_px = smoothing_for_noise(noise);
    LabPicture flat = lab;
    if (smoothing_px > 0.0) {
        cv::GaussianBlur(lab, flat, cv::Size(), smoothing_px);
    }
    const Paper paper(flat);
    if (paper.part() >= kLeastPaper) {
        flat = evenly_lit(flat, paper);
    }
    const std::vector<cv::Vec3f> palette = palette_of(flat, noise);
    const cv::Mat1b map =
        region_map(flat, palette, static_cast<int>(kLeastPart * static_cast<double>(lab.total())));
    std::vector<Chain> lines =
        linked(region_borders(map, flat, palette), lab.size(), reach_of_borders()).chains;
    for (Chain& line : lines) {
        line = with_sharp_corners(line, std::hypot(smoothing_px, kPictureBlur_px));
    }
    return lines;
}

}  // namespace touchline
