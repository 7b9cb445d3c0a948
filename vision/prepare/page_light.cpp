#include "vision/prepare/page_light.h"

#include <opencv2/imgproc.hpp>

namespace touchline {

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

}  // namespace touchline
