#include "vision/camera/frame.h"

#include "tests/vision/camera/frames.h"
#include "vision/camera/capture_sequence.h"

#include <random>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

using testing::mean_difference;

const cv::Size full(640, 480);

cv::Mat reduced(const cv::Mat& picture, cv::Size size) {
    cv::Mat out;
    cv::resize(picture, out, size, 0, 0, cv::INTER_AREA);
    return out;
}

/// Expects the picture itself, averaged down, at every wanted size.
void expect_picture(const CameraFrame& frame, const cv::Mat& picture, double levels) {
    for (const cv::Size size : {full, cv::Size(500, 375), cv::Size(320, 240), cv::Size(161, 121)}) {
        const auto bgr = to_bgr(frame, size);
        ASSERT_TRUE(bgr) << bgr.error().line;
        ASSERT_EQ(bgr->size(), size);
        ASSERT_EQ(bgr->type(), CV_8UC3);
        EXPECT_LT(mean_difference(*bgr, reduced(picture, size)), levels) << size;
    }
}

TEST(Conversion, YuyvIsThePicture) {
    expect_picture(testing::yuyv_frame(testing::scene(full)), testing::scene(full), 2.0);
}

TEST(Conversion, PaddedRowsAreNotPartOfThePicture) {
    expect_picture(testing::yuyv_frame(testing::scene(full), 64), testing::scene(full), 2.0);
    expect_picture(testing::nv12_frame(testing::scene(full), 32), testing::scene(full), 2.5);
}

TEST(Conversion, Nv12IsThePicture) {
    expect_picture(testing::nv12_frame(testing::scene(full)), testing::scene(full), 2.5);
}

TEST(Conversion, MjpegIsThePicture) {
    expect_picture(testing::mjpeg_frame(testing::scene(full)), testing::scene(full), 3.0);
}

TEST(Conversion, MjpegWithoutHuffmanTablesIsThePicture) {
    const CameraFrame whole = testing::mjpeg_frame(testing::scene(full));
    const CameraFrame frame = testing::without_tables(whole);
    ASSERT_LT(frame.bytes.size() + 300, whole.bytes.size());
    expect_picture(frame, testing::scene(full), 3.0);
}

TEST(Conversion, BytesAfterThePictureDoNoHarm) {
    CameraFrame frame = testing::mjpeg_frame(testing::scene(full));
    frame.bytes.insert(frame.bytes.end(), 500, std::uint8_t{0});
    expect_picture(frame, testing::scene(full), 3.0);
}

/// A frame that ends early, at any place, is an error.
TEST(Conversion, CutShortIsAnError) {
    for (const CameraFrame& whole :
         {testing::yuyv_frame(testing::scene(full)), testing::nv12_frame(testing::scene(full)),
          testing::mjpeg_frame(testing::scene(full))}) {
        for (int share = 0; share < 100; share += 3) {
            CameraFrame frame = whole;
            frame.bytes.resize(whole.bytes.size() * static_cast<std::size_t>(share) / 100);
            for (const cv::Size size : {full, full / 4}) {
                const auto bgr = to_bgr(frame, size);
                ASSERT_FALSE(bgr) << share << " % of it";
                EXPECT_EQ(bgr.error().line.find("the camera's frame is damaged: "), 0U);
            }
        }
    }
}

/// A garbled JPEG may still be a JPEG, and then has the wanted size; more often it is an error.
TEST(Conversion, GarbledMjpegNeverCrashesAndIsMostlyAnError) {
    const CameraFrame whole = testing::mjpeg_frame(testing::scene(full));
    std::mt19937 random(7);
    int errors = 0;
    constexpr int rounds = 400;
    for (int round = 0; round < rounds; ++round) {
        CameraFrame frame = whole;
        for (int i = 0; i < 20; ++i)
            frame.bytes[random() % frame.bytes.size()] = static_cast<std::uint8_t>(random());
        const auto bgr = to_bgr(frame, full / 2);
        errors += bgr ? 0 : 1;
        EXPECT_TRUE(!bgr || bgr->size() == full / 2);
    }
    EXPECT_GT(errors, rounds * 3 / 4);
}

TEST(Conversion, AnotherSizeThanAgreedIsAnError) {
    CameraFrame frame = testing::mjpeg_frame(testing::scene(full));
    frame.size = full * 2;
    EXPECT_FALSE(to_bgr(frame, full));
    frame.size = {};
    EXPECT_FALSE(to_bgr(frame, full));
}

TEST(Conversion, AStrideShorterThanARowIsAnError) {
    CameraFrame frame = testing::yuyv_frame(testing::scene(full));
    frame.stride_bytes = 100;
    EXPECT_FALSE(to_bgr(frame, full));
}

TEST(Conversion, ReducedSizeKeepsTheShapeAndTheBound) {
    EXPECT_EQ(reduced_size({4000, 3000}, 1'000'000), cv::Size(1154, 866));
    EXPECT_EQ(reduced_size({640, 480}, 1'000'000), cv::Size(640, 480));
    EXPECT_EQ(reduced_size({65535, 1}, 100), cv::Size(100, 1));
    EXPECT_EQ(reduced_size({3, 65535}, 1000), cv::Size(1, 1000));
}

TEST(Conversion, QuickSizeIsAPowerOfTwoBelowTheBound) {
    EXPECT_EQ(quick_size({4000, 3000}, 1'000'000), cv::Size(1000, 750));
    EXPECT_EQ(quick_size({1001, 751}, 1'000'000), cv::Size(1001, 751));
    EXPECT_EQ(quick_size({1601, 1201}, 1'000'000), cv::Size(801, 601));
    EXPECT_EQ(quick_size({16000, 12000}, 1000), cv::Size(2000, 1500));
    const CameraFrame frame = testing::mjpeg_frame(testing::scene({1601, 1201}));
    EXPECT_EQ(to_bgr(frame, cv::Size(801, 601))->size(), cv::Size(801, 601));
}

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
