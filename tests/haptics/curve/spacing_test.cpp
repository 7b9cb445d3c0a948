// No more points than a scene needs, judged by code of its own: how few uniform points would do.
#include "haptics/curve/spacing.h"

#include "app/decode/map_svg.h"
#include "app/gallery/gallery.h"
#include "haptics/curve/pins.h"
#include "haptics/curve/sampling.h"
#include "tests/haptics/scenes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace touchline {
namespace {

struct Line {
    std::vector<Position> points;
    bool is_closed = false;
};

std::vector<Line> lines_of(const TactileMap& map) {
    std::vector<Line> lines;
    const auto pins = find_pins(map.outlines, PinRule{});
    for (std::size_t i = 0; i < pins.size(); ++i) {
        const Outline& outline = map.outlines[i];
        const std::size_t count = outline.points.size();
        std::vector<std::size_t> ends = pins[i];
        const bool is_closed = ends.empty();
        if (is_closed) ends.push_back(0);
        if (outline.is_closed) ends.push_back(ends.front() + count);
        for (std::size_t k = 1; k < ends.size(); ++k) {
            Line line{{}, is_closed};
            for (std::size_t j = ends[k - 1]; j <= ends[k]; ++j) {
                line.points.push_back(outline.points[j % count]);
            }
            lines.push_back(std::move(line));
        }
    }
    return lines;
}

/// Farthest that a data point lies from the polyline, by looking at every segment.
double farthest_m(std::span<const Position> data, std::span<const Position> kept) {
    double farthest = 0.0;
    for (const Position p : data) {
        double nearest = 1.0;
        for (std::size_t i = 1; i < kept.size(); ++i) {
            nearest = std::min(nearest, scenes::distance_m(p, {kept[i - 1], kept[i]}));
        }
        farthest = std::max(farthest, nearest);
    }
    return farthest;
}

std::size_t uniform_count(const Line& line, double spacing_m) {
    const double wanted = std::ceil(polyline_length_m(line.points) / spacing_m * (1.0 - 1e-9));
    return static_cast<std::size_t>(std::max(wanted, 1.0));
}

std::size_t uniform_total(const std::vector<Line>& lines, double spacing_m) {
    std::size_t total = 0;
    for (const Line& line : lines) total += uniform_count(line, spacing_m);
    return total;
}

bool is_near(const std::vector<Line>& lines, double spacing_m) {
    return std::all_of(lines.begin(), lines.end(), [&](const Line& line) {
        const auto kept = resample(line.points, uniform_count(line, spacing_m));
        return farthest_m(line.points, kept) <= scene_tolerance_m;
    });
}

/// Segments of the fewest uniform points, one spacing for all lines: each bisection over one octave
/// of spacings may end on another side of a lucky fit, so the best of all octaves counts.
std::size_t fewest_uniform(const std::vector<Line>& lines) {
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    for (double octave_m = 0.128; octave_m > 1e-4; octave_m *= 0.5) {
        double fine = 0.5 * octave_m;
        double coarse = octave_m;
        if (!is_near(lines, fine)) continue;
        while (coarse > 1.0001 * fine) {
            const double middle = std::sqrt(fine * coarse);
            (is_near(lines, middle) ? fine : coarse) = middle;
        }
        fewest = std::min(fewest, uniform_total(lines, fine));
    }
    return fewest;
}

std::size_t segments_of(const CurveSet& curves) {
    int total = 0;
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        total += curves.segment_count(piece, 0);
    }
    return static_cast<std::size_t>(total);
}

double farthest_m(const std::vector<Line>& lines, const CurveSet& curves) {
    double farthest = 0.0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto points = curves.points(static_cast<int>(i), 0);
        std::vector<Position> kept(points.begin(), points.end());
        if (lines[i].is_closed) kept.push_back(kept.front());
        farthest = std::max(farthest, farthest_m(lines[i].points, kept));
    }
    return farthest;
}

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
    const auto lines = lines_of(map);
    const CurveSet curves = CurveSet::build(map, {.resample = true}).value();
    ASSERT_EQ(lines.size(), curves.pieces().size());
    const std::size_t kept = segments_of(curves);
    EXPECT_LE(farthest_m(lines, curves), scene_tolerance_m);
    EXPECT_LE(static_cast<double>(kept), 1.1 * static_cast<double>(fewest_uniform(lines)));
    const CurveOptions wider{.resample = true, .spacing_m = curves.reports()[0].spacing_m / 0.75};
    if (kept > lines.size()) {  // else each line is one straight segment: no fewer exist
        EXPECT_GT(farthest_m(lines, CurveSet::build(map, wider).value()), scene_tolerance_m);
        EXPECT_FALSE(is_near(lines, wider.spacing_m));
    }
}

INSTANTIATE_TEST_SUITE_P(
    Spacing, Gallery,
    testing::ValuesIn(list_gallery(TOUCHLINE_SOURCE_DIR "/app/gallery/pictures").value()));

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
        EXPECT_LE(curves.reports()[0].spacing_m, 1.25 * step_m);
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
