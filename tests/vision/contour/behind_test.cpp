// What lies behind the lines of a drawing and is not a line: shadows, gradients, grids.
#include "config/types/angle.h"
#include "tests/vision/pictures/canvas.h"
#include "vision/contour/regions.h"
#include "vision/contour/strokes.h"

#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

using testing::Canvas;
using testing::Polyline;

constexpr double widest_stroke_px = 25.0;
const cv::Size picture_size(900, 650);
const cv::Scalar white_bgr(255, 255, 255);
const cv::Scalar dark_bgr(90, 40, 20);
const cv::Scalar pale(216, 216, 216);

/// Keeps the lines of at least 4 mm; shorter ones are specks to a hand.
std::vector<Chain> flat_lines(const cv::Mat& bgr) {
    const LabPicture lab = to_lab(bgr);
    std::vector<Chain> lines = region_lines(lab, noise_of(lab), widest_stroke_px);
    std::erase_if(lines, [](const Chain& line) { return length_of(line) < 40.0; });
    return lines;
}

Polyline box(const cv::Rect2d& r) {
    return {
        {{r.x, r.y}, {r.x + r.width, r.y}, {r.x + r.width, r.y + r.height}, {r.x, r.y + r.height}},
        true};
}

double farthest_px(const std::vector<Chain>& lines, const cv::Rect2d& r) {
    double farthest = 0.0;
    for (const Chain& line : lines) {
        for (const EdgePoint& p : line.points) {
            const cv::Point2d at = p.at + cv::Point2d(0.5, 0.5);
            const double x = std::max({r.x - at.x, at.x - r.x - r.width, 0.0});
            const double y = std::max({r.y - at.y, at.y - r.y - r.height, 0.0});
            const double inside =
                std::min({at.x - r.x, r.x + r.width - at.x, at.y - r.y, r.y + r.height - at.y});
            farthest = std::max(farthest, inside > 0.0 ? inside : std::hypot(x, y));
        }
    }
    return farthest;
}

TEST(Behind, AShadowIsNoLine) {
    for (const double blur_px : {5.0, 8.0, 14.0}) {
        for (const cv::Point2d& off : {cv::Point2d(8, 8), {0, 12}, {-6, 10}}) {
            const cv::Rect2d shape(250, 180, 400, 260);
            Canvas canvas(picture_size, white_bgr);
            canvas.fill({box(shape + off)}, {140, 140, 140});
            cv::Mat picture = canvas.picture();
            cv::GaussianBlur(picture, picture, {}, blur_px);
            Canvas above(picture_size, white_bgr);
            above.fill({box(shape)}, dark_bgr);
            above.picture().copyTo(picture,
                                   above.picture() != cv::Mat(picture_size, CV_8UC3, white_bgr));
            const cv::Rect inside(shape);
            picture(inside) = dark_bgr;
            const auto lines = flat_lines(picture);
            ASSERT_EQ(lines.size(), 1U) << blur_px << " " << off;
            EXPECT_TRUE(lines.front().is_closed);
            EXPECT_LT(farthest_px(lines, shape), 2.0);
        }
    }
}

TEST(Behind, AGradientHasNoLinesInside) {
    for (const double turn_deg : {0.0, 30.0, 90.0}) {
        const cv::Rect shape(200, 150, 500, 350);
        cv::Mat picture(picture_size, CV_8UC3, white_bgr);
        const double a = radians(turn_deg);
        for (int y = shape.y; y < shape.br().y; ++y) {
            for (int x = shape.x; x < shape.br().x; ++x) {
                const double t =
                    ((x - shape.x) * std::cos(a) + (y - shape.y) * std::sin(a)) / 620.0;
                picture.at<cv::Vec3b>(y, x) = {static_cast<uchar>(150 - 130 * t),
                                               static_cast<uchar>(20 + 150 * t),
                                               static_cast<uchar>(160 - 100 * t)};
            }
        }
        const auto lines = flat_lines(picture);
        ASSERT_EQ(lines.size(), 1U) << turn_deg;
        EXPECT_TRUE(lines.front().is_closed);
        EXPECT_LT(farthest_px(lines, shape), 2.0);
    }
}

/// A shape that is as white as the paper at one end still stays whole.
TEST(Behind, AShapeThatFadesIntoThePaperStaysWhole) {
    const cv::Rect shape(200, 150, 500, 350);
    cv::Mat picture(picture_size, CV_8UC3, white_bgr);
    for (int x = shape.x; x < shape.br().x; ++x) {
        picture(cv::Rect(x, shape.y, 1, shape.height)) =
            cv::Scalar::all(40.0 + 215.0 * (x - shape.x) / shape.width);
    }
    double left_side_px = 0.0;
    for (const Chain& line : flat_lines(picture)) {
        for (const EdgePoint& p : line.points) {
            left_side_px += std::abs(p.at.x + 0.5 - shape.x) < 2.0 ? 1.0 : 0.0;
        }
    }
    EXPECT_GT(left_side_px, 0.8 * shape.height);
}

/// The shape is white at both ends. A side with a step is felt, one without is not, and the ground
/// stays whole although the gradient fills most of the picture.
TEST(Behind, WhereAShapeFadesAwayItHasNoLine) {
    const cv::Rect shape(100, 80, 700, 490);
    for (const double darkest : {0.0, 190.0}) {
        cv::Mat picture(picture_size, CV_8UC3, white_bgr);
        for (int x = shape.x; x < shape.br().x; ++x) {
            const double from_middle =
                std::abs(x - shape.x - 0.5 * shape.width) / (0.5 * shape.width);
            picture(cv::Rect(x, shape.y, 1, shape.height)) =
                cv::Scalar::all(darkest + (255.0 - darkest) * from_middle);
        }
        const auto lines = flat_lines(picture);
        double level_px = 0.0;
        for (const Chain& line : lines) {
            for (const EdgePoint& p : line.points) {
                const double beside_px = std::min(std::abs(p.at.y + 0.5 - shape.y),
                                                  std::abs(p.at.y + 0.5 - shape.br().y));
                EXPECT_LT(beside_px, 2.5) << darkest << " " << p.at;
            }
            level_px += length_of(line);
        }
        EXPECT_EQ(lines.size(), 2U) << darkest;
        EXPECT_GT(level_px, 2.0 * 0.6 * shape.width) << darkest;
    }
}

/// The paper that a frame leaves over is not a stroke, however near to it something lies.
TEST(Behind, AFrameIsFeltWhereItIs) {
    const cv::Rect2d frame(6, 6, 888, 638);
    for (const double top : {14.0, 120.0}) {
        Canvas canvas(picture_size, white_bgr);
        canvas.stroke({box(frame)}, 4.0, {0, 0, 0});
        canvas.fill({box({400, top, 90, 90})}, dark_bgr);
        const auto lines = flat_lines(canvas.picture());
        ASSERT_EQ(lines.size(), 2U) << top;
        const auto stroke =
            std::ranges::find_if(lines, [](const Chain& line) { return line.width_px > 0.0; });
        ASSERT_NE(stroke, lines.end()) << top;
        EXPECT_NEAR(stroke->width_px, 4.0, 1.0) << top;
        EXPECT_LT(farthest_px({*stroke}, frame), 1.5) << top;
    }
}

void draw_grid(Canvas& canvas, double tilt_deg, bool both_ways, const cv::Scalar& ink) {
    const double tilt = std::tan(radians(tilt_deg));
    for (double at = 60; at < 620; at += 70) {
        canvas.stroke({{{{20, at}, {880, at + 860 * tilt}}, false}}, 2.0, ink);
    }
    for (double at = 60; at < 880 && both_ways; at += 70) {
        canvas.stroke({{{{at, 20}, {at - 610 * tilt, 630}}, false}}, 2.0, ink);
    }
}

TEST(Behind, APaleGridIsNoLine) {
    for (const double tilt_deg : {0.0, 1.3, -2.0}) {
        for (const bool both_ways : {false, true}) {
            Canvas canvas(picture_size, white_bgr);
            draw_grid(canvas, tilt_deg, both_ways, pale);
            const cv::Rect2d shape(250, 180, 300, 260);
            canvas.fill({box(shape)}, dark_bgr);
            const auto lines = flat_lines(canvas.picture());
            ASSERT_EQ(lines.size(), 1U) << tilt_deg << " " << both_ways;
            EXPECT_LT(farthest_px(lines, shape), 4.0);
        }
    }
}

TEST(Behind, SquaredPaperIsNoLineOfTheDrawingOnIt) {
    Canvas canvas(picture_size, white_bgr);
    draw_grid(canvas, 0.5, true, {235, 215, 190});
    canvas.stroke({testing::arc({450, 320}, {220, 180})}, 5.0, dark_bgr);
    const LabPicture lab = to_lab(canvas.picture());
    const auto lines = stroke_lines(lab, noise_of(lab), widest_stroke_px);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_TRUE(lines.front().is_closed);
}

TEST(Behind, AGridThatIsAllThereIsIsFelt) {
    Canvas canvas(picture_size, white_bgr);
    draw_grid(canvas, 0.0, true, pale);
    EXPECT_GE(flat_lines(canvas.picture()).size(), 12U);
}

/// A pale drawing beside a dark one is not a grid: its lines are not evenly spaced.
TEST(Behind, APaleDrawingIsFelt) {
    Canvas canvas(picture_size, white_bgr);
    canvas.fill({box({60, 60, 200, 200})}, dark_bgr);
    for (const double y : {330.0, 360.0, 440.0, 585.0}) {
        canvas.stroke({{{{320, y}, {860, y}}, false}}, 3.0, pale);
    }
    EXPECT_EQ(flat_lines(canvas.picture()).size(), 5U);
}

}  // namespace
}  // namespace touchline
