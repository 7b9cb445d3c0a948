#include "tests/vision/camera/frames.h"
#include "vision/camera/capture_sequence.h"
#include "vision/camera/frame.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

const cv::Size judged(1024, 768);

TEST(FrameQualityTest, APageInFocusIsAboveTheLimitAndOneOutOfFocusBelow) {
    const double limit = CaptureLimits{}.least_sharpness;
    const cv::Mat sharp = testing::scene(judged);
    double before = measure_quality(sharp).sharpness;
    EXPECT_GT(before, 5 * limit);
    for (const double sigma_px : {1.0, 2.0, 4.0}) {
        cv::Mat blurred;
        cv::GaussianBlur(sharp, blurred, {}, sigma_px);
        const double now = measure_quality(blurred).sharpness;
        EXPECT_LT(now, before / 2) << sigma_px;
        before = now;
    }
    EXPECT_LT(before, limit);
}

TEST(FrameQualityTest, ClippedIsTheShareThatIsFullyLit) {
    cv::Mat picture(100, 100, CV_8UC3, cv::Scalar(240, 240, 240));
    EXPECT_EQ(measure_quality(picture).clipped_share, 0.0);
    picture.rowRange(0, 3).setTo(cv::Scalar(255, 255, 255));
    EXPECT_DOUBLE_EQ(measure_quality(picture).clipped_share, 0.03);
}

TEST(FrameQualityTest, BrightnessIsTheMean) {
    EXPECT_DOUBLE_EQ(measure_quality(cv::Mat(9, 9, CV_8UC3, cv::Scalar(70, 70, 70))).brightness,
                     70.0);
}

}  // namespace
}  // namespace touchline
