#include "vision/contour/photo_lines.h"
#include "vision/contour/rings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

cv::Mat1f bump(cv::Size size, cv::Point2d centre, double radius) {
    cv::Mat1f values(size);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            values(y, x) = static_cast<float>(radius - distance(cv::Point2d(x, y), centre));
        }
    }
    return values;
}

RC_GTEST_PROP(IsoRings, RunRoundADiscAtItsRadius, ()) {
    const cv::Point2d centre(20.0 + 0.01 * *rc::gen::inRange(0, 1000),
                             20.0 + 0.01 * *rc::gen::inRange(0, 1000));
    const double radius = 3.0 + 0.01 * *rc::gen::inRange(0, 1500);
    const std::vector<Chain> rings = iso_rings(bump({50, 50}, centre, radius), 0.0F);
    RC_ASSERT(rings.size() == 1U);
    RC_ASSERT(rings[0].is_closed);
    for (const EdgePoint& p : rings[0].points) {
        RC_ASSERT(std::abs(distance(p.at, centre) - radius) < 0.1);
    }
    const double disc = std::numbers::pi * radius * radius;
    RC_ASSERT(std::abs(area_within(rings[0]) - disc) < 0.1 * disc);
}

RC_GTEST_PROP(IsoRings, PassEachPlaceBetweenHighAndLowOnce, ()) {
    const auto bits = *rc::gen::container<std::vector<bool>>(48, rc::gen::arbitrary<bool>());
    cv::Mat1f values(6, 8);
    for (int i = 0; i < 48; ++i) {
        values(i / 8, i % 8) = bits[static_cast<std::size_t>(i)] ? 1.0F : 0.0F;
    }
    const auto is_high = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < 8 && y < 6 && values(y, x) > 0.5F;
    };
    std::size_t steps = 0;
    for (int y = -1; y < 6; ++y) {
        for (int x = -1; x < 8; ++x) {
            steps += is_high(x, y) != is_high(x + 1, y) ? 1U : 0U;
            steps += is_high(x, y) != is_high(x, y + 1) ? 1U : 0U;
        }
    }
    std::size_t points = 0;
    for (const Chain& ring : iso_rings(values, 0.5F)) {
        points += ring.points.size();
    }
    RC_ASSERT(points == steps);
}

TEST(IsoRings, AHoleHasItsOwnRingTheOtherWayRound) {
    cv::Mat1f values(9, 9, 1.0F);
    values(4, 4) = 0.0F;
    const std::vector<Chain> rings = iso_rings(values, 0.5F);
    ASSERT_EQ(rings.size(), 2U);
    EXPECT_NEAR(area_within(rings[0]), 80.5, 1.0);  // 9 x 9 minus the corners
    EXPECT_NEAR(area_within(rings[1]), -0.5, 0.1);
}

const cv::Size picture_size(600, 400);
constexpr TextureScale texture_scale{.spacing_px = 12.0, .longest_px = 80.0, .smallest_px = 60.0};

/// Upright strokes of `length_px`, `spacing_px` apart both ways, all over a rectangle.
std::vector<Chain> grass(cv::Rect2d where, double spacing_px, double length_px) {
    std::vector<Chain> blades;
    for (double x = where.x; x < where.x + where.width; x += spacing_px) {
        for (double y = where.y; y + length_px <= where.y + where.height; y += length_px + 2.0) {
            Chain blade;
            for (double t = 0.0; t <= length_px; t += 1.0) {
                blade.points.push_back({{x, y + t}, 7.0});
            }
            blades.push_back(std::move(blade));
        }
    }
    return blades;
}

Chain level_line(double y) {
    Chain line;
    for (int x = 10; x < 590; ++x) {
        line.points.push_back({{static_cast<double>(x), y}, 20.0});
    }
    return line;
}

TEST(Texture, ManyShortLinesCloseTogetherBecomeOneOutlineRoundThem) {
    const cv::Rect2d meadow(100, 100, 200, 150);
    std::vector<Chain> lines = grass(meadow, 6.0, 18.0);
    lines.push_back(level_line(170.0));                        // a long line through them
    lines.push_back(grass({500, 50, 20, 20}, 30.0, 18.0)[0]);  // a short one on its own
    const std::vector<Chain> after = with_textures_outlined(lines, picture_size, texture_scale);
    EXPECT_LT(after.size(), lines.size() / 10);
    EXPECT_EQ(std::ranges::count(after, LineOf::texture, &Chain::of), 1);
    EXPECT_TRUE(std::ranges::any_of(after, [](const Chain& c) { return length_of(c) == 579.0; }));
    EXPECT_TRUE(std::ranges::any_of(
        after, [](const Chain& c) { return c.points.front().at == cv::Point2d(500, 50); }));
    const Chain& outline = after.back();
    EXPECT_EQ(outline.of, LineOf::texture);
    EXPECT_TRUE(outline.is_closed);
    EXPECT_NEAR(area_within(outline), meadow.area(), 0.25 * meadow.area());
    for (const EdgePoint& p : outline.points) {
        EXPECT_NEAR(p.strength, 7.0, 1e-9);
        EXPECT_TRUE((cv::Rect2d(meadow.x - 20, meadow.y - 20, 240, 190).contains(p.at))) << p.at;
    }
}

TEST(Texture, AtTheFrameTheOutlineRunsAlongIt) {
    const std::vector<Chain> after =
        with_textures_outlined(grass({0, 200, 250, 200}, 6.0, 18.0), picture_size, texture_scale);
    ASSERT_EQ(after.back().of, LineOf::texture);
    double left = 1e9;
    double bottom = -1e9;
    for (const EdgePoint& p : after.back().points) {
        left = std::min(left, p.at.x);
        bottom = std::max(bottom, p.at.y);
    }
    EXPECT_EQ(left, -0.5);
    EXPECT_EQ(bottom, 399.5);
}

RC_GTEST_PROP(Texture, SparseLongFewOrSmallIsNoTexture, ()) {
    const int kind = *rc::gen::inRange(0, 4);
    const cv::Rect2d all(50, 50, 300, 200);
    const double spacing = 4.0 + *rc::gen::inRange(0, 5);
    const std::vector<Chain> lines = kind == 0   ? grass(all, 20.0, 18.0)                  // sparse
                                     : kind == 1 ? grass(all, spacing, 90.0)               // long
                                     : kind == 2 ? grass({50, 50, 40, 40}, spacing, 18.0)  // small
                                                 : grass({0, 0, 600, 400}, spacing, 18.0);  // all
    const std::vector<Chain> after = with_textures_outlined(lines, picture_size, texture_scale);
    RC_ASSERT(after.size() == lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
        RC_ASSERT(after[i].of == LineOf::edge);
        RC_ASSERT(after[i].points.size() == lines[i].points.size());
        RC_ASSERT(after[i].points.front().at == lines[i].points.front().at);
    }
}

}  // namespace
}  // namespace touchline
