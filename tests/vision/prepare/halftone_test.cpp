#include "vision/prepare/halftone.h"

#include "config/types/angle.h"
#include "tests/vision/pictures/canvas.h"
#include "tests/vision/pictures/scenes.h"
#include "vision/simplify/trace.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

const cv::Size print_size(1000, 724);

/// A dark square on pale paper, printed as dots of black ink of this pitch.
cv::Mat printed(double pitch_px, double turn_deg) {
    const double turn = radians(turn_deg);
    const cv::Rect square(300, 160, 400, 400);
    cv::Mat fine(print_size * 2, CV_8U);
    for (int y = 0; y < fine.rows; ++y) {
        for (int x = 0; x < fine.cols; ++x) {
            const cv::Point2d at(0.5 * x, 0.5 * y);
            const double u = (at.x * std::cos(turn) + at.y * std::sin(turn)) / pitch_px;
            const double v = (at.y * std::cos(turn) - at.x * std::sin(turn)) / pitch_px;
            const double ink = square.contains(cv::Point(at)) ? 0.65 : 0.1;
            const double radius = std::sqrt(ink / std::numbers::pi);
            const double off = std::hypot(u - std::round(u), v - std::round(v));
            fine.at<uchar>(y, x) = off < radius ? 20 : 250;
        }
    }
    cv::Mat picture;
    cv::resize(fine, picture, print_size, 0.0, 0.0, cv::INTER_AREA);
    return picture;
}

TEST(Halftone, DotsAreMeasured) {
    for (const double pitch_px : {4.0, 6.0, 8.0, 12.0}) {
        for (const double turn_deg : {0.0, 15.0, 45.0, 75.0}) {
            EXPECT_NEAR(dot_pitch(printed(pitch_px, turn_deg)), pitch_px, 0.1 * pitch_px)
                << pitch_px << " px, turned by " << turn_deg;
        }
    }
}

TEST(Halftone, WhatIsNotPrintedInDotsStaysAsItIs) {
    for (int seed = 0; seed < 6; ++seed) {
        EXPECT_EQ(dot_pitch(testing::photo_scene(seed, {800, 600}).picture), 0.0) << seed;
        EXPECT_EQ(dot_pitch(testing::diagram(seed, {800, 600})), 0.0) << seed;
        EXPECT_EQ(dot_pitch(testing::line_drawing(seed, {800, 600})), 0.0) << seed;
        EXPECT_EQ(dot_pitch(testing::text_page(seed, {800, 1000})), 0.0) << seed;
    }
    EXPECT_EQ(dot_pitch(cv::Mat(40, 40, CV_8U, cv::Scalar(9))), 0.0);
    EXPECT_EQ(dot_pitch(cv::Mat(300, 300, CV_8UC3, cv::Scalar::all(9))), 0.0);
}

TEST(Halftone, APrintedShapeIsFeltAsItsShape) {
    for (const double pitch_px : {5.0, 8.0}) {
        for (const double turn_deg : {0.0, 45.0}) {
            const auto traced =
                find_lines(printed(pitch_px, turn_deg), {}).and_then([](const Found& found) {
                    return trace_lines(found, {});
                });
            ASSERT_TRUE(traced.has_value()) << traced.error().line;
            ASSERT_EQ(traced->map.outlines.size(), 1U) << pitch_px << " px, " << turn_deg;
            EXPECT_TRUE(traced->map.outlines.front().is_closed);
            const double mm_per_px = 116.0 / print_size.width;
            for (const Position& p : traced->map.outlines.front().points) {
                const double side_mm =
                    1e3 * std::max(std::abs(p.x), std::abs(p.y + 2e-3 * mm_per_px));
                EXPECT_NEAR(side_mm, 200.0 * mm_per_px, 1.5);
            }
        }
    }
}

}  // namespace
}  // namespace touchline
