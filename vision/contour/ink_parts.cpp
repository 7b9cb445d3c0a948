#include "vision/contour/ink_parts.h"

#include <algorithm>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr int kLeastArea_px = 8;  // less ink is a speck, less paper a pinhole
constexpr double kClearlyWide = 1.25;
constexpr double kLeastTailOverWidth = 1.0;  // what stands out of a wide shape less is its corner

/// Without the pieces of a mask that are too small, by neighbours of 4 or of 8.
cv::Mat without_specks(const cv::Mat& mask, int neighbours) {
    cv::Mat1i label;
    cv::Mat1i stats;
    cv::Mat1d centres;
    cv::connectedComponentsWithStats(mask, label, stats, centres, neighbours, CV_32S);
    cv::Mat kept = mask.clone();
    for (int y = 0; y < mask.rows; ++y) {
        for (int x = 0; x < mask.cols; ++x) {
            if (stats(label(y, x), cv::CC_STAT_AREA) < kLeastArea_px) {
                kept.at<uchar>(y, x) = 0;
            }
        }
    }
    return kept;
}

/// Where the ink is deeper than a stroke's, in places clearly so: between two strokes that meet at
/// a sharp angle it is a little deeper.
cv::Mat wide_cores(const cv::Mat1f& depth, double greatest_width_px) {
    const cv::Mat deep = depth > 0.5 * greatest_width_px;
    cv::Mat1i label;
    const int n = cv::connectedComponents(deep, label, 8, CV_32S);
    std::vector<float> deepest(static_cast<std::size_t>(n), 0.0F);
    for (int y = 0; y < depth.rows; ++y) {
        for (int x = 0; x < depth.cols; ++x) {
            float& of_core = deepest[static_cast<std::size_t>(label(y, x))];
            of_core = std::max(of_core, label(y, x) != 0 ? depth(y, x) : 0.0F);
        }
    }
    cv::Mat cores(depth.size(), CV_8U, cv::Scalar(0));
    for (int y = 0; y < depth.rows; ++y) {
        for (int x = 0; x < depth.cols; ++x) {
            const double d = static_cast<double>(deepest[static_cast<std::size_t>(label(y, x))]);
            cores.at<uchar>(y, x) = d > kClearlyWide * 0.5 * greatest_width_px ? 255 : 0;
        }
    }
    return cores;
}

/// What of the ink is wider than a stroke: everywhere that a disc of that width fits, and the
/// corners round it; tails that stand out by more than a width stay strokes.
cv::Mat1b wide_part(const cv::Mat1b& mask, const cv::Mat1f& depth, double greatest_width_px) {
    const cv::Mat core = wide_cores(depth, greatest_width_px);
    if (cv::countNonZero(core) == 0) {
        return cv::Mat1b(mask.size(), uchar{0});
    }
    const cv::Mat1f from_core = depth_of(~core);
    cv::Mat wide = (from_core <= 0.5 * greatest_width_px + 1.0) & mask;
    cv::Mat1i label;
    const cv::Mat rest = mask & ~wide;
    const int n = cv::connectedComponents(rest, label, 8, CV_32S);
    std::vector<float> reach(static_cast<std::size_t>(n), 0.0F);
    for (int y = 0; y < mask.rows; ++y) {
        for (int x = 0; x < mask.cols; ++x) {
            float& farthest = reach[static_cast<std::size_t>(label(y, x))];
            farthest = std::max(farthest, from_core(y, x));
        }
    }
    const double tail_px = (0.5 + kLeastTailOverWidth) * greatest_width_px;
    for (int y = 0; y < mask.rows; ++y) {
        for (int x = 0; x < mask.cols; ++x) {
            if (label(y, x) != 0 &&
                static_cast<double>(reach[static_cast<std::size_t>(label(y, x))]) < tail_px) {
                wide.at<uchar>(y, x) = 255;
            }
        }
    }
    return wide;
}

}  // namespace

cv::Mat1f depth_of(const cv::Mat& mask) {
    cv::Mat1f depth;
    cv::distanceTransform(mask, depth, cv::DIST_L2, 5);
    return depth;
}

InkParts parts_of(const cv::Mat1b& ink, double greatest_width_px) {
    InkParts parts;
    // Pinholes lie where two strokes begin to part.
    const cv::Mat paper = ~without_specks(ink, 8);
    const cv::Mat1b mask = cv::Mat(~without_specks(paper, 4));
    parts.depth = depth_of(mask);
    parts.shapes = wide_part(mask, parts.depth, greatest_width_px);
    parts.strokes = cv::Mat(mask & ~parts.shapes);
    parts.pieces = cv::connectedComponents(mask, parts.piece, 8, CV_32S);
    return parts;
}

}  // namespace touchline
