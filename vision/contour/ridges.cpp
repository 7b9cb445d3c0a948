#include "vision/contour/ridges.h"

#include <algorithm>

#include <opencv2/imgproc.hpp>

namespace touchline {

GradientField ridges_of(const cv::Mat1f& probability) {
    GradientField field{{}, cv::Mat2f(probability.size()), false};
    cv::GaussianBlur(probability, field.strength, cv::Size(), kRidgeSmoothing_px,
                     kRidgeSmoothing_px, cv::BORDER_REPLICATE);
    const cv::Mat1f& p = field.strength;
    for (int y = 0; y < p.rows; ++y) {
        const float* above = p[std::max(0, y - 1)];
        const float* here = p[y];
        const float* below = p[std::min(p.rows - 1, y + 1)];
        for (int x = 0; x < p.cols; ++x) {
            const int left = std::max(0, x - 1);
            const int right = std::min(p.cols - 1, x + 1);
            const float dxx = here[right] - 2.0F * here[x] + here[left];
            const float dyy = below[x] - 2.0F * here[x] + above[x];
            const float dxy = 0.25F * (below[right] - below[left] - above[right] + above[left]);
            field.normal(y, x) = major_axis(-dxx, -dyy, -dxy);
        }
    }
    return field;
}

}  // namespace touchline
