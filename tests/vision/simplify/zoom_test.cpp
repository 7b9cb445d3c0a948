#include "vision/simplify/zoom.h"

#include "tests/vision/contour/shapes.h"
#include "vision/simplify/trace.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace touchline::testing {
namespace {

const Area area{};

cv::Mat picture_of(cv::Point2d centre, double size_px) {
    return drawn(test_shapes(centre, size_px, 0.0)[0], {464, 336}, {});
}

TEST(Zoom, WhatLeavesTheAreaIsCutOnItsRim) {
    const auto found = find_lines(picture_of({232.0, 168.0}, 150.0), {});
    ASSERT_TRUE(found);
    const auto quarter =
        trace_lines(*found, {.area = {}, .zoom = {{-0.25 * area.width_m, 0.0}, 2.0}});
    ASSERT_TRUE(quarter);
    ASSERT_EQ(quarter->map.outlines.size(), 1U);
    const Outline& arc = quarter->map.outlines[0];
    EXPECT_FALSE(arc.is_closed);
    EXPECT_NEAR(arc.points.front().x, 0.5 * area.width_m, 1e-9);
    EXPECT_NEAR(arc.points.back().x, 0.5 * area.width_m, 1e-9);
    const double radius_m = 2.0 * 75.0 / (464 / area.width_m);
    for (const Position& p : arc.points) {
        EXPECT_NEAR(norm(p - Position{0.5 * area.width_m, 0.0}), radius_m, 0.0006);
    }
}

TEST(Zoom, DetailAppliesToWhatIsThere) {
    cv::Mat picture(336, 464, CV_8UC1, cv::Scalar(255));
    for (int i = 0; i < 12; ++i) {  // squares in three rows, 2.5 mm apart
        const cv::Rect square(10 + 28 * (i % 4), 10 + 28 * (i / 4), 18, 18);
        picture(square).setTo(cv::Scalar::all(0));
    }
    const auto found = find_lines(picture, {.area = {}, .picture_class = PictureClass::diagram});
    ASSERT_TRUE(found);
    const auto whole = trace_lines(*found, {.area = {}, .detail = 4});
    const auto near =
        trace_lines(*found, {.area = {}, .detail = 4, .zoom = {{-0.038, 0.024}, 3.0}});
    ASSERT_TRUE(whole && near);
    const auto closed = [](const TactileMap& map) {
        return std::ranges::count_if(map.outlines, &Outline::is_closed);
    };
    EXPECT_LT(closed(whole->map), 4);  // 2.5 mm between them: too near
    EXPECT_GE(closed(near->map), 8);
}

TEST(Zoom, AMapIsClippedOnTheRimAndItsLabelsGoWithIt) {
    TactileMap map;
    map.outlines.push_back({{{-0.02, -0.02}, {0.02, -0.02}, {0.02, 0.02}, {-0.02, 0.02}},
                            true,
                            "square",
                            "side",
                            1.0,
                            1});
    map.outlines.push_back({{{-0.05, 0.0}, {-0.04, 0.0}}, false, "dash", "", 1.0, 1});
    map.labels = {{"corner", {0.02, 0.02}}, {"other", {-0.02, -0.02}}};
    EXPECT_EQ(enlarged(map, {}).outlines.size(), 2U);
    const TactileMap near = enlarged(map, {{0.02, 0.02}, 4.0});
    ASSERT_EQ(near.outlines.size(), 1U);  // the corner, open, from rim to rim
    const Outline& corner = near.outlines[0];
    EXPECT_FALSE(corner.is_closed);
    EXPECT_EQ(corner.id, "square");
    EXPECT_EQ(corner.label, "side");
    ASSERT_EQ(corner.points.size(), 3U);
    EXPECT_NEAR(norm(corner.points[1]), 0.0, 1e-8);
    EXPECT_NEAR(std::abs(corner.points[0].y), 0.5 * area.height_m, 1e-8);
    EXPECT_NEAR(std::abs(corner.points[2].x), 0.5 * area.width_m, 1e-8);
    ASSERT_EQ(near.labels.size(), 1U);
    EXPECT_EQ(near.labels[0].text, "corner");
    EXPECT_TRUE(enlarged(map, {{0.0, 0.0}, 16.0}).outlines.empty());
}

TEST(Zoom, WhatIsFoundBeyondTheAreaComesToItsRim) {
    const cv::Size picture(464, 336);  // four pixels a millimetre
    const Chain corner{{{{-9.0, 100.0}, 1.0}, {{100.0, 400.0}, 1.0}, {{200.0, 100.0}, 1.0}}, false};
    const auto lines = in_zoom({corner}, Placement(picture, picture, area), area, {});
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].points[0].at.x, 0.0);
    EXPECT_EQ(lines[0].points[1].at.y, 84.0);
    EXPECT_NEAR(lines[0].points[2].at.x, 200.5 / 4.0, 1e-9);
    EXPECT_NEAR(lines[0].points[2].at.y, 100.5 / 4.0, 1e-9);
}

TEST(Zoom, NothingThereAndOutOfRangeAreOneLine) {
    const auto found = find_lines(picture_of({100.0, 100.0}, 90.0), {});
    ASSERT_TRUE(found);
    const auto empty = trace_lines(*found, {.area = {}, .zoom = {{0.04, -0.02}, 4.0}});
    ASSERT_FALSE(empty);
    EXPECT_NE(empty.error().line.find("choose another part"), std::string::npos);
    for (const double factor : {0.5, 17.0, std::numeric_limits<double>::quiet_NaN()}) {
        const auto wrong = trace_lines(*found, {.area = {}, .zoom = {{}, factor}});
        ASSERT_FALSE(wrong);
        EXPECT_NE(wrong.error().line.find("must be 1 to 16"), std::string::npos);
    }
}

}  // namespace
}  // namespace touchline::testing
