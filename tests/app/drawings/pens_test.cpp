// Tests strokes that come as pixels: each line of dashes or dots is felt as one line; crossing
// strokes, thin and thick, are a line or an area all along.
#include "tests/app/drawings/pens.h"

#include "tests/app/drawings/felt.h"
#include "tests/app/drawings/scans.h"
#include "vision/simplify/detail_limits.h"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace touchline {
namespace {

double length_mm(const std::vector<cv::Point2d>& points, bool is_closed) {
    double sum = is_closed ? cv::norm(points.front() - points.back()) : 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) sum += cv::norm(points[i] - points[i - 1]);
    return sum;
}

double dashed_mm(const testing::Drawing& drawing) {
    double sum = 0.0;
    for (const testing::Paint& paint : drawing.paints)
        for (const testing::Polyline& line : paint.lines)
            sum += paint.dashes_mm.empty() ? 0.0 : length_mm(line.points, line.is_closed);
    return sum;
}

double named_mm(const TactileMap& map) {
    double sum = 0.0;
    for (const Outline& outline : map.outlines) {
        const bool is_named = outline.label.find("dashed") != std::string::npos ||
                              outline.label.find("dotted") != std::string::npos;
        std::vector<cv::Point2d> points;
        for (const Position& p : outline.points) points.emplace_back(1e3 * p.x, 1e3 * p.y);
        sum += is_named ? length_mm(points, outline.is_closed) : 0.0;
    }
    return sum;
}

TEST(Pens, ABrokenLineInAFlatPictureIsOneAndIsNamedSo) {
    testing::Counted seen;
    testing::Counted felt;
    double dashed = 0.0;
    double named = 0.0;
    for (const testing::Dashing& dashing : testing::dashings())
        for (const bool is_scan : {false, true}) {
            const testing::Drawing clean = testing::dashed_drawing(dashing, 1);
            const auto drawing =
                is_scan ? testing::scanned(clean, 1) : testing::as_pixels(clean, {});
            ASSERT_TRUE(drawing.has_value()) << drawing.error().line;
            const auto found = testing::felt_of(*drawing, most_detail, testing::usual_tolerance_mm);
            ASSERT_TRUE(found.has_value()) << drawing->name << ": " << found.error().line;
            fmt::print("{}: {:.1f} % felt, {:.0f} of {:.0f} mm named\n", drawing->name,
                       100.0 * found->seen.share(), named_mm(found->map), dashed_mm(clean));
            seen += found->seen;
            felt += found->felt;
            dashed += dashed_mm(clean);
            named += std::min(named_mm(found->map), dashed_mm(clean));
        }
    EXPECT_GE(seen.share(), 0.95);
    EXPECT_GE(felt.share(), 0.99);
    EXPECT_GE(named, 0.94 * dashed);
}

TEST(Pens, AStrokeIsALineOrAnAreaThroughAllThatItCrosses) {
    constexpr int most_seeds = 10;
    testing::Counted seen;
    testing::Counted felt;
    for (int seed = 0; seed < most_seeds; ++seed) {
        const testing::Drawing clean = testing::crossing_strokes(seed);
        const auto drawing =
            seed % 2 == 1 ? testing::scanned(clean, seed) : testing::as_pixels(clean, {});
        ASSERT_TRUE(drawing.has_value()) << drawing.error().line;
        const auto found = testing::felt_of(*drawing, most_detail, testing::usual_tolerance_mm);
        ASSERT_TRUE(found.has_value()) << drawing->name << ": " << found.error().line;
        seen += found->seen;
        felt += found->felt;
    }
    fmt::print("{:.2f} % of what is seen is felt, {:.2f} % of what is felt is seen\n",
               100.0 * seen.share(), 100.0 * felt.share());
    EXPECT_GE(seen.share(), 0.99);
    EXPECT_GE(felt.share(), 0.995);
}

TEST(Pens, BrokenLinesAloneAreFeltAndNamed) {
    for (const testing::Drawing& clean : testing::broken_line_art())
        for (const bool is_pixels : {false, true}) {
            const auto drawing = is_pixels ? testing::as_pixels(clean, {}) : clean;
            ASSERT_TRUE(drawing.has_value()) << drawing.error().line;
            for (const int detail : {3, most_detail}) {
                const auto found = testing::felt_of(*drawing, detail, testing::usual_tolerance_mm);
                ASSERT_TRUE(found.has_value()) << drawing->name << ": " << found.error().line;
                const double named = named_mm(found->map) / dashed_mm(clean);
                fmt::print("{}, detail {}: {:.1f} % felt, {:.1f} % named\n", drawing->name, detail,
                           100.0 * found->seen.share(), 100.0 * named);
                EXPECT_GE(found->seen.share(), 0.7) << drawing->name << ", detail " << detail;
                EXPECT_GE(named, 0.7) << drawing->name << ", detail " << detail;
            }
        }
}

/// One stroke is felt, not its two sides.
TEST(Pens, AThinFilledOutlineIsOneLine) {
    for (const double width_mm : {0.6, 2.0})
        for (const bool is_even_odd : {true, false})
            for (const int detail : {3, most_detail}) {
                const testing::Drawing drawing = testing::thin_fills(width_mm, is_even_odd);
                SCOPED_TRACE(fmt::format("{}, detail {}", drawing.name, detail));
                const auto found = testing::felt_of(drawing, detail, testing::usual_tolerance_mm);
                ASSERT_TRUE(found.has_value()) << found.error().line;
                ASSERT_EQ(found->map.outlines.size(), 2U);
                for (const Outline& outline : found->map.outlines) EXPECT_TRUE(outline.is_closed);
                EXPECT_GE(found->seen.share(), 0.99);
                EXPECT_GE(found->felt.share(), 0.99);
            }
}

/// Strokes of zero length are painted if their caps are round.
TEST(Pens, ADotOfARoundCapAloneIsARing) {
    testing::Drawing drawing;
    drawing.file = R"(<svg xmlns="http://www.w3.org/2000/svg" width="400" height="300">)"
                   R"(<g stroke="#000" stroke-width="30" stroke-linecap="round">)"
                   R"(<path d="M260 150h0"/><path d="M140 150h0"/></g></svg>)";
    for (const int detail : {3, most_detail}) {
        const auto view = testing::whole_view_of(drawing, detail, 1e12);
        ASSERT_TRUE(view.has_value()) << view.error().line;
        ASSERT_EQ(view->map.outlines.size(), 2U) << detail;
        for (const Outline& outline : view->map.outlines) {
            EXPECT_TRUE(outline.is_closed);
            const double side = outline.points.front().x > 0.0 ? 1.0 : -1.0;
            for (const Position& p : outline.points)  // 400 x 300 on 84 mm: 0.28 mm a unit
                EXPECT_NEAR(std::hypot(1e3 * p.x - side * 0.28 * 60.0, 1e3 * p.y), 0.28 * 15.0,
                            0.5);
        }
    }
}

}  // namespace
}  // namespace touchline
