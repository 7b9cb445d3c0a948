#include "vision/contour/courses.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr float stroke_px = 5.0F;
constexpr int hairpin_top_px = 20;
constexpr int hairpin_bottom_px = 120;

/// Goes up a column, over the tip, and down two columns to the right.
std::vector<EdgePoint> tip_at(int column) {
    std::vector<EdgePoint> points;
    for (int y = hairpin_bottom_px; y >= hairpin_top_px; --y)
        points.push_back({cv::Point2d(column, y)});
    points.push_back({cv::Point2d(column + 1, hairpin_top_px - 1)});
    for (int y = hairpin_top_px; y <= hairpin_bottom_px; ++y)
        points.push_back({cv::Point2d(column + 2, y)});
    return points;
}

/// Ink as deep as one stroke, and `tip_px` deep in the rows about the tips.
cv::Mat1f ink(float tip_px) {
    cv::Mat1f depth(140, 140, stroke_px);
    depth.rowRange(hairpin_top_px - 5, hairpin_top_px + 4).setTo(tip_px);
    return depth;
}

Skeleton of_arm(Chain arm) {
    return {{std::move(arm)}, {}};
}

TEST(Hairpins, AnArmThatTurnsBackInDeepInkIsTwo) {
    const Skeleton made = with_hairpins_parted(of_arm({tip_at(60), false}), ink(8.0F));
    ASSERT_EQ(made.arms.size(), 2U);
    EXPECT_EQ(made.nodes, (std::vector<std::vector<EndId>>{{back_of(0), front_of(1)}}));
    EXPECT_EQ(made.arms[0].points.back().at, cv::Point2d(61, hairpin_top_px - 1));
    EXPECT_EQ(made.arms[1].points.front().at, made.arms[0].points.back().at);
    EXPECT_EQ(made.arms[0].points.front().at, cv::Point2d(60, hairpin_bottom_px));
    EXPECT_EQ(made.arms[1].points.back().at, cv::Point2d(62, hairpin_bottom_px));
}

TEST(Hairpins, ABendOfOneStrokeStays) {
    EXPECT_EQ(with_hairpins_parted(of_arm({tip_at(60), false}), ink(stroke_px)).arms.size(), 1U);
}

TEST(Hairpins, DeepInkOnAStraightWayIsNone) {
    std::vector<EdgePoint> points;
    for (int y = hairpin_bottom_px; y >= 0; --y) points.push_back({cv::Point2d(60, y)});
    EXPECT_EQ(with_hairpins_parted(of_arm({points, false}), ink(8.0F)).arms.size(), 1U);
}

TEST(Hairpins, ARingIsCutAtEachTipWhereverItBegins) {
    std::vector<EdgePoint> ring = tip_at(30);
    for (int x = 33; x < 90; ++x) ring.push_back({cv::Point2d(x, hairpin_bottom_px)});
    for (const EdgePoint& point : tip_at(90)) ring.push_back(point);
    for (int x = 92; x >= 30; --x) ring.push_back({cv::Point2d(x, hairpin_bottom_px + 2)});
    const cv::Mat1f depth = ink(8.0F);
    for (std::size_t begin = 0; begin < ring.size(); begin += 7) {
        std::vector<EdgePoint> points = ring;
        std::ranges::rotate(points, points.begin() + static_cast<std::ptrdiff_t>(begin));
        const Skeleton made = with_hairpins_parted(of_arm({points, true}), depth);
        ASSERT_EQ(made.arms.size(), 2U) << begin;
        ASSERT_EQ(made.nodes.size(), 2U) << begin;
        EXPECT_EQ(made.nodes[0], (std::vector<EndId>{back_of(0), front_of(1)}));
        EXPECT_EQ(made.nodes[1], (std::vector<EndId>{back_of(1), front_of(0)}));
        for (const std::size_t arm : {std::size_t{0}, std::size_t{1}}) {
            EXPECT_FALSE(made.arms[arm].is_closed);
            EXPECT_EQ(made.arms[arm].points.back().at, made.arms[1 - arm].points.front().at);
        }
        EXPECT_EQ(made.arms[0].points.size() + made.arms[1].points.size(), ring.size() + 2);
    }
}

TEST(Hairpins, NodesKeepTheirEnds) {
    Skeleton skeleton = of_arm({tip_at(60), false});
    skeleton.arms.push_back(
        {{{cv::Point2d(62, hairpin_bottom_px)}, {cv::Point2d(90, hairpin_bottom_px)}}, false});
    skeleton.nodes = {{back_of(0), front_of(1)}};
    const Skeleton made = with_hairpins_parted(skeleton, ink(8.0F));
    ASSERT_EQ(made.arms.size(), 3U);
    ASSERT_EQ(made.nodes.size(), 2U);
    EXPECT_EQ(made.nodes[0], (std::vector<EndId>{back_of(0), front_of(1)}));
    EXPECT_EQ(made.nodes[1], (std::vector<EndId>{back_of(1), front_of(2)}));
}

}  // namespace
}  // namespace touchline
