#include "haptics/curve/spacing.h"

#include "app/documents/decode/map_svg.h"
#include "app/documents/gallery/gallery.h"
#include "tests/haptics/curve/uniform_points.h"
#include "tests/haptics/scenes.h"

#include <cmath>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using uniform::farthest_m;
using uniform::segments_of;

TactileMap one_line(std::vector<Position> points) {
    return scenes::map_of({scenes::outline(std::move(points), false)});
}

/// Even steps of 1 mm along an arc of 20 mm radius.
std::vector<Position> arc(int segments) {
    std::vector<Position> points;
    for (int i = 0; i <= segments; ++i) {
        points.push_back({0.02 * std::cos(0.05 * i), 0.02 * std::sin(0.05 * i)});
    }
    return points;
}

class Gallery : public testing::TestWithParam<GalleryEntry> {};

TEST_P(Gallery, TakesNoMorePointsThanItNeedsAndQuarterFewerWouldNotDo) {
    const TactileMap map = read_map_svg(GetParam().path).value();
    const auto lines = uniform::lines_of(map);
    const CurveSet curves = CurveSet::build(map, {.resample = true}).value();
    ASSERT_EQ(lines.size(), curves.pieces().size());
    const std::size_t kept = segments_of(curves);
    EXPECT_LE(farthest_m(lines, curves), scene_tolerance_m);
    EXPECT_LE(static_cast<double>(kept),
              1.1 * static_cast<double>(uniform::bisected_segments(lines)));
    const CurveOptions wider{.resample = true, .spacing_m = curves.reports()[0].spacing_m / 0.75};
    if (kept > lines.size()) {  // otherwise each line is one straight segment, and no fewer exist
        EXPECT_GT(farthest_m(lines, CurveSet::build(map, wider).value()), scene_tolerance_m);
        EXPECT_FALSE(uniform::is_near(lines, wider.spacing_m));
    }
}

INSTANTIATE_TEST_SUITE_P(Spacing, Gallery,
                         testing::ValuesIn(list_gallery(TOUCHLINE_SOURCE_DIR
                                                        "/app/documents/gallery/pictures")
                                               .value()));

TEST(Spacing, CountsAreFourToSevenTimesAPowerOfTwo) {
    EXPECT_EQ(count_below(0.2, false), 1U);
    EXPECT_EQ(count_below(7.9, false), 7U);
    EXPECT_EQ(count_above(7.1, false), 8U);
    EXPECT_EQ(count_below(9.9, false), 8U);
    EXPECT_EQ(count_below(111.0, false), 96U);
    EXPECT_EQ(count_above(97.0, false), 112U);
    EXPECT_EQ(count_above(113.0, false), 128U);
    EXPECT_EQ(nearest_count(103.0, false), 96U);
    EXPECT_EQ(nearest_count(105.0, false), 112U);
    EXPECT_EQ(count_below(2.0, true), 8U);
    EXPECT_EQ(count_above(2.0, true), 8U);
    EXPECT_EQ(count_above(8.5, true), 10U);
}

TEST(Spacing, AStraightLineIsOneSegment) {
    const CurveSet curves =
        CurveSet::build(one_line({{0, 0}, {0.01, 0}, {0.013, 0}, {0.05, 0}}), {.resample = true})
            .value();
    EXPECT_EQ(curves.reports()[0].points_kept, 2U);
}

TEST(Spacing, IsNeverFinerThanTheDevicesStepAndSaysSo) {
    std::vector<Position> jagged;  // teeth of 0.4 mm, every 0.2 mm: too fine for a step of 0.2 mm
    for (int i = 0; i <= 400; ++i) jagged.push_back({1e-4 * i, i % 2 == 0 ? 0.0 : 4e-4});
    for (const double step_m : {2e-4, 3e-4}) {
        const CurveOptions options{.resample = true, .device_step_m = step_m};
        const CurveSet curves = CurveSet::build(one_line(jagged), options).value();
        const double spacing_m =
            polyline_length_m(jagged) / static_cast<double>(segments_of(curves));
        EXPECT_GE(spacing_m, step_m);
        EXPECT_LE(spacing_m, 1.25 * step_m);
        EXPECT_GE(curves.reports()[0].spacing_m, step_m);
        // Two roundings to m 2^L, each by a quarter at most.
        EXPECT_LE(curves.reports()[0].spacing_m, 1.5625 * step_m);
        EXPECT_EQ(curves.reports()[0].reason.rfind("device:", 0), 0U) << curves.reports()[0].reason;
    }
}

TEST(Spacing, DataThatAreEvenAndCoarseStayAsTheyAre) {
    std::vector<Position> gentle;  // turns of 40 degrees at even steps of 8 mm: not pinned
    double heading = 0.0;
    Position at{-0.03, 0.0};
    for (int i = 0; i <= 7; ++i) {
        gentle.push_back(at);
        heading += i % 2 == 0 ? 0.69 : -0.69;
        at += 0.008 * Position{std::cos(heading), std::sin(heading)};
    }
    const CurveSet curves = CurveSet::build(one_line(gentle), {.resample = true}).value();
    EXPECT_EQ(curves.reports()[0].points_kept, 8U);
    EXPECT_EQ(curves.reports()[0].reason.rfind("data:", 0), 0U) << curves.reports()[0].reason;
    for (std::size_t i = 0; i < gentle.size(); ++i) {
        EXPECT_LE(norm(curves.points(0, 0)[i] - gentle[i]), 1e-15);
    }
}

TEST(Spacing, TheOutlineThatNeedsItSetsThePicturesSpacing) {
    const TactileMap map = scenes::map_of(
        {scenes::outline(arc(40), false), scenes::outline({{-0.03, 0.03}, {0.03, 0.03}}, false)});
    const CurveSet curves = CurveSet::build(map, {.resample = true}).value();
    EXPECT_EQ(curves.reports()[0].reason.rfind("scene: the fewest", 0), 0U);
    EXPECT_EQ(curves.reports()[1].reason.rfind("scene: one spacing", 0), 0U);
    EXPECT_DOUBLE_EQ(curves.reports()[0].spacing_m, curves.reports()[1].spacing_m);
}

}  // namespace
}  // namespace touchline
