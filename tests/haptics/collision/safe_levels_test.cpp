// On the way from level to level no line passes over one that it does not cross at level 0.
#include "haptics/collision/collision_builder.h"
#include "haptics/collision/scene.h"
#include "tests/haptics/collision/meetings.h"
#include "tests/haptics/collision/trials.h"
#include "tests/haptics/scenes.h"
#include "tests/lab/bench/workload.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// Two rings, one `gap_m` within the other, with waves that coarse levels lose; their vertices lie
/// at different places.
TactileMap nested_rings(unsigned seed, double gap_m) {
    std::vector<Outline> rings;
    const double waves = 5.0 + seed % 23;
    for (const double inset_m : {0.0, gap_m}) {
        const int edges = inset_m > 0.0 ? 213 : 256;
        std::vector<Position> points;
        for (int i = 0; i < edges; ++i) {
            const double angle = 2.0 * std::numbers::pi * (i + 0.37) / edges;
            const double radius_m = 0.03 - inset_m + 0.003 * std::sin(waves * angle);
            points.push_back(radius_m * Position{std::cos(angle), std::sin(angle)});
        }
        rings.push_back(scenes::outline(std::move(points), true));
    }
    return scenes::map_of(std::move(rings));
}

TEST(SafeLevels, LinesThatDoNotMeetAtLevel0MeetAtNoOther) {
    int apart = 0;
    int unsafe = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        const TactileMap map = nested_rings(seed, 0.0025 - 5e-5 * seed);
        const CurveSet every = trials::every_level(map).curves;
        if (trials::meetings(every, 0.0) > 0) continue;
        ++apart;
        unsafe += trials::levels_with_meetings(every) > 0 ? 1 : 0;
        const Scene scene = build_scene(map, {}, 0.0).value();
        EXPECT_EQ(trials::levels_with_meetings(scene.curves), 0) << seed;
    }
    EXPECT_GT(apart, 10);
    EXPECT_GT(unsafe, 5);  // of those apart, with all levels kept
}

/// Two waves that cross in the middle at 10 degrees, with 400 edges of 0.2 mm each.
TactileMap crossing_waves() {
    std::vector<Outline> waves;
    for (const double sign : {1.0, -1.0}) {
        std::vector<Position> points;
        for (int i = -200; i <= 200; ++i) {
            const double x = 2e-4 * i;
            const double y = sign * std::tan(std::numbers::pi / 36.0) * x;
            points.push_back({x, y + 5e-4 * std::sin(600.0 * x)});
        }
        waves.push_back(scenes::outline(std::move(points), false));
    }
    return scenes::map_of(std::move(waves));
}

TEST(SafeLevels, PinsPartACrossingFromTheRest) {
    const TactileMap map = crossing_waves();
    const CurveSet every = trials::every_level(map).curves;
    const CurveSet safe = build_scene(map, {}, 0.0).value().curves;
    ASSERT_GT(safe.pieces().size(), every.pieces().size());
    std::size_t fine = 0;
    std::size_t all = 0;
    for (int piece = 0; piece < static_cast<int>(safe.pieces().size()); ++piece) {
        const int edges = safe.segment_count(piece, 0);
        const int kept = safe.pieces()[static_cast<std::size_t>(piece)].coarsest;
        const double length_m = 2e-4 * edges / safe.segment_count(piece, kept);
        fine += length_m < 1.25e-3 ? static_cast<std::size_t>(edges) : 0;
        all += static_cast<std::size_t>(edges);
    }
    EXPECT_EQ(all, every.finest_count() - 2);
    EXPECT_LE(fine, all / 10);
    for (double level = 0.0; level <= safe.coarsest(); level += 0.0625) {
        EXPECT_GT(trials::meetings(safe, level), 0) << level;  // they still cross
    }
}

TEST(SafeLevels, TakeNothingFromLinesThatKeepClearOfThemselves) {
    for (const auto kind : {workload::Kind::radial, workload::Kind::fractal}) {
        const TactileMap map = workload::map_of(workload::curve(kind, 4096));
        const CurveSet every = trials::every_level(map).curves;
        const CurveSet safe = build_scene(map, {}, 0.0).value().curves;
        ASSERT_EQ(safe.pieces().size(), every.pieces().size());
        for (std::size_t piece = 0; piece < safe.pieces().size(); ++piece) {
            EXPECT_EQ(safe.pieces()[piece].coarsest, every.pieces()[piece].coarsest);
        }
    }
}

/// Compares what a builder finds that knows the pieces of a build with fewer pins with what one
/// finds that knows nothing. Returns whether there were new pins.
bool compare_with_unknowing(const TactileMap& map, const CurveOptions& options) {
    const CurveSource source = CurveSource::read(map, options).value();
    const CurveSet before = source.build({}).value();
    CollisionTreeBuilder first(before);
    Meetings met = first.find_meetings();
    const auto pins = pins_for(before, find_safe_levels(before, met));
    const CurveSet curves = source.build(pins).value();
    CollisionTreeBuilder knowing(curves, std::move(first).known_pieces(std::move(met)));
    CollisionTreeBuilder unknowing(curves);
    EXPECT_EQ(knowing.find_meetings().pairs, unknowing.find_meetings().pairs);
    const CollisionTree found = std::move(knowing).finish(0.0);
    const CollisionTree expected = CollisionTree::build(curves, 0.0);
    for (int piece = 0; piece < curves.piece_count(); ++piece) {
        for (int level = 0; level <= curves.piece(piece).coarsest; ++level) {
            for (int j = 0; j < curves.segment_count(piece, level); ++j) {
                const std::size_t node =
                    curves.first_point(piece, level) + static_cast<std::size_t>(j);
                EXPECT_EQ(found.box(curves, piece, level, j).corners,
                          expected.box(curves, piece, level, j).corners);
                EXPECT_EQ(found.is_alone(node), expected.is_alone(node));
            }
        }
    }
    return curves.piece_count() > before.piece_count();
}

TEST(SafeLevels, PiecesThatNoNewPinCutsAreAsIfBuiltAnew) {
    int built_again = 0;
    for (unsigned seed = 0; seed < 30; ++seed) {
        for (const bool resample : {false, true}) {
            const TactileMap map = scenes::random_map(seed, 8);
            built_again += compare_with_unknowing(map, {.resample = resample}) ? 1 : 0;
        }
    }
    EXPECT_GT(built_again, 20);
}

}  // namespace
}  // namespace touchline
