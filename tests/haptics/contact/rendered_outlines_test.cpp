// Edges as the contact machine looks them up.
#include "haptics/contact/rendered_outlines.h"

#include "tests/haptics/scenes.h"

#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double mm = 1e-3;

Scene scene_of(const std::vector<std::vector<Position>>& lines) {
    std::vector<Outline> made;
    for (std::vector<Position> points : lines) {
        for (Position& p : points) p = mm * p;
        made.push_back(scenes::outline(points, false));
    }
    CurveOptions options;
    options.spacing_m = 1.0;  // no edge is split
    return build_scene(scenes::map_of(made), options, 0.0).value();
}

/// Returns each edge of the outline that begins with that piece, in order.
std::vector<Edge> edges(RenderedOutlines& outlines, int piece = 0) {
    std::vector<Edge> found;
    for (SegmentRef at{piece, 0}; at.piece >= 0; at = outlines.next(at, true))
        found.push_back(outlines.edge(at));
    return found;
}

TEST(RenderedOutlines, KnowAnEdgesDirectionAndLength) {
    const Scene scene = scene_of({{{0, 0}, {3, 4}, {3, 10}}});
    RenderedOutlines outlines(scene, 0.0);
    const std::vector<Edge> found = edges(outlines);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_NEAR(found[0].length_m, 5.0 * mm, 1e-15);
    EXPECT_NEAR(found[0].per_length_m, 200.0, 1e-9);
    EXPECT_NEAR(found[0].along.x, 0.6, 1e-12);
    EXPECT_NEAR(found[0].along.y, 0.8, 1e-12);
    EXPECT_EQ(outlines.edge(found[0].ref).length_m, found[0].length_m);  // asked for again
    EXPECT_NEAR(found[1].length_m, 6.0 * mm, 1e-15);
}

/// A slide is open up to the end of a line, and up to an edge that does not run back beside it.
TEST(RenderedOutlines, ASlideIsOpenWhereNothingRunsBack) {
    const Scene scene = scene_of({{{0, 0}, {10, 0}, {20, 2}, {14, 6}, {4, 8}}});
    RenderedOutlines outlines(scene, 0.0);
    const std::vector<Edge> found = edges(outlines);
    ASSERT_EQ(found.size(), 4U);
    const bool ahead[] = {true, false, true, true};
    const bool behind[] = {true, true, false, true};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(outlines.is_open(found[i].ref, true), ahead[i]) << i;
        EXPECT_EQ(outlines.is_open(found[i].ref, false), behind[i]) << i;
    }
}

TEST(RenderedOutlines, ASlideIsOpenIntoARightAngle) {
    const Scene scene = scene_of({{{0, 0}, {8, 0}, {8, 8}}});
    RenderedOutlines outlines(scene, 0.0);
    const std::vector<Edge> found = edges(outlines);
    EXPECT_TRUE(outlines.is_open(found[0].ref, true));
    EXPECT_TRUE(outlines.is_open(found[1].ref, false));
}

/// Less is known of a blended line, or of one with another line near.
TEST(RenderedOutlines, NoSlideIsOpenBetweenLevelsOrBesideAnotherLine) {
    const Scene scene = scene_of({{{0, 0}, {10, 0}}, {{0, 20}, {10, 20}}, {{5, 19}, {5, 21}}});
    for (const double level : {0.0, 0.5}) {
        RenderedOutlines outlines(scene, level);
        for (int piece = 0; piece < 3; ++piece) {
            for (const bool is_forward : {true, false}) {
                EXPECT_EQ(outlines.is_open({piece, 0}, is_forward), piece == 0 && level == 0.0)
                    << piece << " " << level;
            }
        }
    }
}

TEST(RenderedOutlines, KnowWhichSegmentsThereAre) {
    const Scene scene = scene_of({{{0, 0}, {10, 0}}, {{0, 20}, {10, 20}}});
    const RenderedOutlines outlines(scene, 0.0);
    EXPECT_TRUE(outlines.has({0, 0}));
    EXPECT_TRUE(outlines.has({1, 0}));
    EXPECT_FALSE(outlines.has({-1, 0}));
    EXPECT_FALSE(outlines.has({2, 0}));
    EXPECT_FALSE(outlines.has({0, -1}));
    EXPECT_FALSE(outlines.has({1, 1}));
}

}  // namespace
}  // namespace touchline
