// Tests lines that a hand cannot tell apart.
#include "app/documents/decode/map_svg.h"
#include "app/documents/gallery/gallery.h"
#include "app/documents/packs/unpack_work.h"

#include <chrono>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

namespace touchline {
namespace {

Outline line(double x0_mm, double y0_mm, double x1_mm, double y1_mm) {
    Outline made;
    made.points = {{x0_mm / 1000.0, y0_mm / 1000.0}, {x1_mm / 1000.0, y1_mm / 1000.0}};
    return made;
}

TactileMap map_of_lines(std::vector<Outline> outlines) {
    TactileMap map;
    map.outlines = std::move(outlines);
    return map;
}

TEST(HandRoom, ParallelLinesAreNearBelowThreeMillimetres) {
    for (const double gap_mm : {1.0, 2.0, 2.9}) {
        const auto near =
            near_lines(map_of_lines({line(-30, 0, 30, 0), line(-30, gap_mm, 30, gap_mm)}), 5);
        ASSERT_EQ(near.size(), 1U) << gap_mm;
        EXPECT_NEAR(1000.0 * near[0].gap_m, gap_mm, 0.05);
    }
    EXPECT_TRUE(
        near_lines(map_of_lines({line(-30, 0, 30, 0), line(-30, 3.1, 30, 3.1)}), 5).empty());
}

TEST(HandRoom, LinesThatMeetMayBeNearThere) {
    EXPECT_TRUE(near_lines(map_of_lines({line(-30, 0, 30, 0), line(-30, -20, 30, 20)}), 5).empty());
    EXPECT_TRUE(near_lines(map_of_lines({line(-30, 0, 30, 0), line(0, 0, 0, 20)}), 5).empty());
    // One end is near the other line but does not reach it.
    EXPECT_EQ(near_lines(map_of_lines({line(-30, 0, 30, 0), line(0, 1.5, 0, 20)}), 5).size(), 1U);
}

TEST(HandRoom, ALineThatComesBackToItselfIsNear) {
    Outline hairpin;
    hairpin.points = {{-0.03, 0.0}, {0.03, 0.0}, {0.03, 0.002}, {-0.03, 0.002}};
    const auto near = near_lines(map_of_lines({hairpin}), 5);
    ASSERT_EQ(near.size(), 1U);
    EXPECT_EQ(near[0].one, near[0].other);
}

TEST(HandRoom, TheRimIsThreeMillimetresWide) {
    EXPECT_FALSE(is_near_rim(line(-55, 0, 55, 0), Area{}));
    EXPECT_TRUE(is_near_rim(line(-55.1, 0, 55, 0), Area{}));
    EXPECT_TRUE(is_near_rim(line(0, -39.1, 0, 0), Area{}));
}

/// 400 m of line in a square centimetre, as an attacker might send.
TEST(HandRoom, ATangleIsLookedAtInBoundedTime) {
    std::vector<Outline> tangle;
    for (int i = 0; i < 40'000; ++i) {
        const double turn = 0.01 * i;
        tangle.push_back(line(-5.0 * std::cos(turn), -5.0 * std::sin(turn), 5.0 * std::cos(turn),
                              5.0 * std::sin(turn)));
    }
    const auto start = std::chrono::steady_clock::now();
    EXPECT_LE(near_lines(map_of_lines(std::move(tangle)), 5).size(), 5U);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    EXPECT_LT(took.count(), 20.0);  // even under a sanitizer
    std::printf("%.2f s\n", took.count());
}

/// Carefully drawn pictures cause no finding.
TEST(HandRoom, ThePicturesOfTheGalleryHaveRoom) {
    const auto gallery = list_gallery(gallery_folder());
    ASSERT_TRUE(gallery.has_value());
    for (const GalleryEntry& entry : *gallery) {
        const auto map = read_map_svg(entry.path);
        ASSERT_TRUE(map.has_value());
        for (const NearLines& near : near_lines(*map, 3))
            ADD_FAILURE() << entry.path << ": " << map->outlines[near.one].id << ' '
                          << map->outlines[near.other].id << ' ' << 1000.0 * near.gap_m;
        EXPECT_LE(part_count(*map), static_cast<std::size_t>(most_parts(*entry.difficulty)))
            << entry.path;
    }
}

}  // namespace
}  // namespace touchline
