// Thin letters at every level: the narrow strokes, counters and curls of one font.
#include "haptics/collision/scene.h"
#include "tests/haptics/collision/meetings.h"
#include "tests/haptics/scenes.h"
#include "tests/vision/boundary/glyphs.h"

#include <cmath>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double glyph_height_mm = 70.0;
constexpr double path_step_mm = 0.25;

/// The letter's rings in W, points at most path_step_mm apart, corners kept.
TactileMap letter(const std::string& character) {
    std::vector<Outline> rings;
    for (const testing::Polyline& ring :
         testing::glyph(character, {.family = "DejaVu Sans Light"}, {}, glyph_height_mm)) {
        std::vector<Position> points;
        for (std::size_t i = 0; i < ring.points.size(); ++i) {
            const cv::Point2d a = ring.points[i];
            const cv::Point2d b = ring.points[(i + 1) % ring.points.size()];
            const int parts =
                std::max(1, static_cast<int>(std::ceil(cv::norm(b - a) / path_step_mm)));
            for (int k = 0; k < parts; ++k) {
                const cv::Point2d p = a + (b - a) * (static_cast<double>(k) / parts);
                points.push_back({1e-3 * p.x, -1e-3 * p.y});
            }
        }
        rings.push_back(scenes::outline(std::move(points), true));
    }
    return scenes::map_of(std::move(rings));
}

/// Returns twice the signed area within each outline at a level.
std::vector<double> areas_at(const CurveSet& curves, std::size_t outlines, double level) {
    std::vector<double> twice(outlines, 0.0);
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        const RenderedPiece at = curves.rendered(piece, level);
        const int outline = curves.pieces()[static_cast<std::size_t>(piece)].outline;
        for (int j = 0; j < at.segment_count(); ++j) {
            const Segment s = at.segment(j);
            twice[static_cast<std::size_t>(outline)] += s.a.x * s.b.y - s.a.y * s.b.x;
        }
    }
    return twice;
}

TEST(GlyphLevels, ThinLettersNeitherMeetNorTurnOverAtAnyLevel) {
    double coarsest = 0.0;
    for (const std::string& character : testing::letters()) {
        SCOPED_TRACE(character);
        const TactileMap map = letter(character);
        const CurveSet curves = build_scene(map, {}, 0.0).value().curves;
        coarsest = std::max(coarsest, static_cast<double>(curves.coarsest()));
        EXPECT_EQ(trials::levels_with_meetings(curves), 0);
        const std::vector<double> finest = areas_at(curves, map.outlines.size(), 0.0);
        for (double level = 0.25; level <= curves.coarsest(); level += 0.25) {
            const std::vector<double> areas = areas_at(curves, map.outlines.size(), level);
            for (std::size_t i = 0; i < areas.size(); ++i) EXPECT_GT(areas[i] * finest[i], 0.0);
        }
    }
    EXPECT_GE(coarsest, 3.0);
}

}  // namespace
}  // namespace touchline
