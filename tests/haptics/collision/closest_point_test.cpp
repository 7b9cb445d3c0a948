// closest_point() equals a look at every segment, at every level and blend.
#include "haptics/collision/scene.h"
#include "tests/haptics/collision/level_segments.h"
#include "tests/haptics/collision/trials.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace touchline {
namespace {

/// Returns the lowest of the nearest segments, by the same foot() and no tree.
Closest brute_force(const LevelSegments& segments, Position p, double within_m) {
    Closest nearest;
    nearest.distance_m = within_m;
    for (const auto& [ref, segment] : segments.all()) {
        const Foot at = foot(p, segment);
        if (at.distance_m < nearest.distance_m) {
            nearest = {ref, at.parameter, at.point, at.distance_m, 0, true};
        }
    }
    return nearest;
}

double largest_coordinate_m(const LevelSegments& segments) {
    double largest = 0.0;
    for (const auto& [ref, s] : segments.all()) {
        for (const double x : {s.a.x, s.a.y, s.b.x, s.b.y})
            largest = std::max(largest, std::abs(x));
    }
    return largest;
}

// Below this the rounding of the boxes (1e-17 m) may decide which of two equals is looked at.
constexpr double least_told_apart_m = 1e-9;

TEST(ClosestPoint, EqualsLookingAtEverySegment) {
    constexpr int places_each_level = 20;
    const std::size_t wanted = trials::count(50000, 1000000);
    std::size_t asked = 0;
    std::size_t found_any = 0;
    std::size_t wrong = 0;
    for (std::uint64_t seed = 0; asked < wanted; ++seed) {
        trials::Random random(seed);
        const Scene scene = trials::scene_of(trials::small_map(random), seed);
        if (scene.curves.pieces().empty()) continue;
        for (const double level : trials::levels_of(scene.curves)) {
            const LevelSegments segments(scene.curves, level);
            const double size_m = largest_coordinate_m(segments);
            for (int i = 0; i < places_each_level; ++i, ++asked) {
                const Position p = trials::way(random, segments).to;
                const double within_m = i % 2 == 0 ? 1e4 : random.decade(-11.0, -1.0);
                const Closest expected = brute_force(segments, p, within_m);
                const Closest found = scene.tree.closest_point(scene.curves, p, level, within_m);
                const long double exact_m = segments.distance_m(p);
                // The nearest point is rounded to the coordinates of a segment that may be long.
                const long double tolerance_m = 1e-15L * exact_m + 16 * 0x1p-53L * size_m;
                const bool is_near = found.segment.piece < 0
                                         ? exact_m >= within_m - tolerance_m
                                         : std::abs(found.distance_m - exact_m) <= tolerance_m;
                const bool is_same = found.segment == expected.segment &&
                                     found.distance_m == expected.distance_m &&
                                     found.point == expected.point;
                const bool is_told_apart = exact_m > least_told_apart_m;
                const bool is_right = is_near && found.is_complete && (is_same || !is_told_apart);
                found_any += found.segment.piece >= 0 ? 1U : 0U;
                if (is_right || ++wrong > 5) continue;
                ADD_FAILURE() << fmt::format(
                    "seed {} level {} place ({:a}, {:a}) within {:a}: found ({}, {}) at {:.17g}, "
                    "expected ({}, {}) at {:.17g}, exact {:.19g}",
                    seed, level, p.x, p.y, within_m, found.segment.piece, found.segment.index,
                    found.distance_m, expected.segment.piece, expected.segment.index,
                    expected.distance_m, static_cast<double>(exact_m));
            }
        }
    }
    fmt::print("  {} places, {} with a point within the distance, {} wrong\n", asked, found_any,
               wrong);
    EXPECT_EQ(wrong, 0U);
    EXPECT_GT(found_any, asked / 2);
}

}  // namespace
}  // namespace touchline
