#include "vision/prepare/painted_over.h"

#include <vector>

#include <opencv2/imgproc.hpp>

namespace touchline {

cv::Mat3f painted_over(const cv::Mat3f& picture, const cv::Mat1b& mask) {
    cv::Mat1f apart;
    cv::Mat1i nearest;  // the same number for all pixels with the same nearest one outside
    cv::distanceTransform(mask, apart, nearest, cv::DIST_L2, cv::DIST_MASK_5, cv::DIST_LABEL_PIXEL);
    std::vector<cv::Vec3f> colours(picture.total() + 1);
    for (int y = 0; y < mask.rows; ++y) {
        for (int x = 0; x < mask.cols; ++x) {
            if (mask(y, x) == 0) {
                colours[static_cast<std::size_t>(nearest(y, x))] = picture(y, x);
            }
        }
    }
    cv::Mat3f painted = picture.clone();
    for (int y = 0; y < mask.rows; ++y) {
        for (int x = 0; x < mask.cols; ++x) {
            if (mask(y, x) != 0) {
                painted(y, x) = colours[static_cast<std::size_t>(nearest(y, x))];
            }
        }
    }
    return painted;
}

}  // namespace touchline
