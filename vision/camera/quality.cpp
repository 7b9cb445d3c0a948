#include "vision/camera/quality.h"

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

/// Converters and compression stop a little below 255.
constexpr int clipped_from = 253;

}  // namespace

FrameQuality measure_quality(const cv::Mat& bgr) {
    cv::Mat grey;
    cv::cvtColor(bgr, grey, cv::COLOR_BGR2GRAY);
    cv::Mat laplacian;
    cv::Laplacian(grey, laplacian, CV_16S);
    cv::Scalar mean;
    cv::Scalar deviation;
    cv::meanStdDev(laplacian, mean, deviation);
    const int clipped = cv::countNonZero(grey >= clipped_from);
    return {deviation[0] * deviation[0],
            static_cast<double>(clipped) / static_cast<double>(grey.total()), cv::mean(grey)[0]};
}

}  // namespace touchline
