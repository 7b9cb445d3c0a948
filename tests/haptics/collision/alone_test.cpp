// Nodes that are alone: a slide over them never asks the tree, so nothing else may be near.
#include "haptics/collision/scene.h"
#include "haptics/collision/touch.h"
#include "tests/exact/orientation.h"
#include "tests/haptics/collision/level_segments.h"
#include "tests/haptics/collision/trials.h"
#include "tests/haptics/scenes.h"
#include "tests/lab/bench/workload.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

double distance_between_m(const Segment& s, const Segment& t) {
    if (exact::meet(s.a, s.b, t.a, t.b)) return 0.0;
    return std::min({scenes::distance_m(s.a, t), scenes::distance_m(s.b, t),
                     scenes::distance_m(t.a, s), scenes::distance_m(t.b, s)});
}

bool is_alone(const Scene& scene, SegmentRef ref, double level) {
    const NodeRange nodes = CollisionTree::nodes(scene.curves, ref.piece, level);
    const int node = nodes.is_blend ? ref.index / 2 : ref.index;
    return scene.tree.is_alone(nodes.first + static_cast<std::size_t>(node));
}

/// Returns the segment and those that a slide looks at anyway.
std::vector<SegmentRef> neighbourhood(const CurveSet& curves, SegmentRef ref, double level) {
    const int each_way = level == std::floor(level) ? 1 : 3;
    std::vector<SegmentRef> near{ref};
    SegmentRef forward = ref;
    SegmentRef back = ref;
    for (int i = 0; i < each_way; ++i) {
        if (forward.piece >= 0) forward = curves.next(forward, level);
        if (back.piece >= 0) back = curves.previous(back, level);
        near.push_back(forward);
        near.push_back(back);
    }
    return near;
}

/// Returns how many segments are alone; expects no stranger within reach of one.
int count_alone(const Scene& scene, double radius_m, double level) {
    int alone = 0;
    const LevelSegments segments(scene.curves, level);
    for (const auto& [ref, segment] : segments.all()) {
        if (!is_alone(scene, ref, level)) continue;
        ++alone;
        const auto near = neighbourhood(scene.curves, ref, level);
        for (const auto& [other, stranger] : segments.all()) {
            if (std::find(near.begin(), near.end(), other) != near.end()) continue;
            EXPECT_GT(distance_between_m(segment, stranger),
                      2.0 * std::max(radius_m, contact_skin_m))
                << level << " " << ref.piece << "," << ref.index << " " << other.piece << ","
                << other.index;
        }
    }
    return alone;
}

TEST(Alone, NothingButNeighboursComesWithinReach) {
    int alone = 0;
    for (unsigned seed = 0; seed < 30; ++seed) {
        const double radius_m = seed % 2 == 0 ? 0.0 : 1e-4;
        const Scene scene = trials::every_level(scenes::random_map(seed, 3), radius_m);
        for (const double level : {0.0, 0.4, 1.0, 1.7, 2.0}) {
            alone += count_alone(scene, radius_m, level);
        }
    }
    EXPECT_GT(alone, 1000);
}

/// A loop with one corner of the given half-angle and a round end 30 mm away: one piece that is its
/// own neighbour.
Outline drop(double half_angle, int points) {
    const double radius = 0.03 * std::sin(half_angle);
    const double arm = 0.03 * std::cos(half_angle);
    const double turn = 3.14159265358979 + 2.0 * half_angle;  // of the round end
    const double length = 2.0 * arm + radius * turn;
    std::vector<Position> line;
    for (int i = 0; i < points; ++i) {
        const double s = length * i / points;
        const double back = length - s;
        const Direction down{std::cos(half_angle), -std::sin(half_angle)};
        const Direction up{down.x, -down.y};
        if (s < arm) {
            line.push_back(along<Position>(down, s));
        } else if (back < arm) {
            line.push_back(along<Position>(up, back));
        } else {
            const double angle = -0.5 * turn + (s - arm) / radius;
            line.push_back(Position{0.03, 0.0} +
                           radius * Position{std::cos(angle), std::sin(angle)});
        }
    }
    return scenes::outline(std::move(line), true);
}

TEST(Alone, NorAcrossTheOnlyPinOfALoop) {
    for (const double half_angle : {0.1, 0.14, 0.3}) {
        for (const double radius_m : {0.0, 1.4e-3}) {
            const TactileMap map = scenes::map_of({drop(half_angle, 256)});
            const Scene scene = trials::every_level(map, radius_m);
            ASSERT_EQ(scene.curves.pieces().size(), 1U);
            ASSERT_EQ(scene.curves.pieces()[0].next, 0);
            int alone = 0;
            for (double level = 0.0; level <= scene.curves.coarsest(); level += 0.5) {
                alone += count_alone(scene, radius_m, level);
            }
            if (radius_m == 0.0) {
                EXPECT_GT(alone, 100);
            }
        }
    }
}

/// A straight arm of 30 mm up to a corner, then an arm that wriggles. Another outline lies 0.1 to
/// 0.5 mm beside it: the wriggling arm keeps few levels, the straight one keeps all of its own.
TactileMap wriggling_corner(unsigned seed) {
    trials::Random random(seed);
    const double angle = 0.8 + 1.6 * random.unit();
    const double height_m = 2e-4 + 8e-4 * random.unit();
    const double per_m = 6.28318530717959 / (2e-3 + 4e-3 * random.unit());
    const double gap_m = 1e-4 + 4e-4 * random.unit();
    const Direction along_arm{std::cos(angle), std::sin(angle)};
    std::vector<Position> cornered;
    std::vector<Position> stranger;
    for (int i = -150; i <= 150; ++i) {
        const double s = 2e-4 * std::abs(i);
        const double aside = height_m * (1.0 - std::exp(-s / 2e-3)) * std::sin(per_m * s);
        const auto beside = [&](double gap) {
            return along<Position>(along_arm, s) + along<Position>(left_of(along_arm), aside + gap);
        };
        cornered.push_back(i < 0 ? Position{s, 0.0} : beside(0.0));
        if (i > 35) stranger.push_back(beside(gap_m));
    }
    return scenes::map_of({scenes::outline(cornered, false), scenes::outline(stranger, false)});
}

TEST(Alone, HoldsForTheLevelsThatALimitedNeighbourKeeps) {
    constexpr double radius_m = 1.4e-3;
    CurveOptions resampled;
    resampled.resample = true;
    int limited = 0;
    int alone = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        const TactileMap map = wriggling_corner(seed);
        const Scene scene = build_scene(map, resampled, radius_m).value();
        const CurveSet all = CurveSet::build(map, resampled).value();
        for (std::size_t i = 0; i < std::min(all.pieces().size(), scene.curves.pieces().size());
             ++i)
            limited += scene.curves.pieces()[i].coarsest < all.pieces()[i].coarsest ? 1 : 0;
        for (double level = 1.0; level <= scene.curves.coarsest(); level += 0.5)
            alone += count_alone(scene, radius_m, level);
    }
    EXPECT_GT(limited, 20);
    EXPECT_GT(alone, 100);
}

/// Returns the share of the nodes of all levels that are alone.
double alone_share(const Scene& scene) {
    std::size_t nodes = 0;
    std::size_t alone = 0;
    for (int piece = 0; piece < static_cast<int>(scene.curves.pieces().size()); ++piece) {
        const int coarsest = scene.curves.pieces()[static_cast<std::size_t>(piece)].coarsest;
        for (int level = 0; level <= coarsest; ++level) {
            for (int j = 0; j < scene.curves.segment_count(piece, level); ++j) {
                ++nodes;
                alone += is_alone(scene, {piece, j}, level) ? 1U : 0U;
            }
        }
    }
    return static_cast<double>(alone) / static_cast<double>(nodes);
}

TEST(Alone, NearlyAllOfASimpleSmoothCurveIs) {
    const Scene round = trials::every_level(scenes::map_of({scenes::circle(0.04, 4096)}));
    EXPECT_GE(alone_share(round), 0.95);
    const TactileMap lobes = workload::map_of(workload::curve(workload::Kind::radial, 4096));
    EXPECT_GE(alone_share(trials::every_level(lobes)), 0.95);
}

/// Turns so close that each crowds all others.
Outline coil(double radius_m, int turns, int points) {
    std::vector<Position> line;
    for (int i = 0; i < points; ++i) {
        const double share = static_cast<double>(i) / points;
        const double angle = 6.28318530717959 * turns * share;
        line.push_back(Position{-0.03, 0.0} +
                       radius_m * (0.1 + share) * Position{std::cos(angle), std::sin(angle)});
    }
    return scenes::outline(std::move(line), false);
}

TEST(Alone, ACrowdElsewhereChangesNothing) {
    constexpr double radius_m = 1.4e-3;
    constexpr int points = 12000;
    const TactileMap map = scenes::map_of({coil(0.001, 40, points), scenes::circle(0.015, points)});
    const Scene scene = trials::every_level(map, radius_m);
    int alone = 0;
    for (int piece = 0; piece < scene.curves.piece_count(); ++piece) {
        const int level = scene.curves.piece(piece).coarsest;
        for (int j = 0; j < scene.curves.segment_count(piece, level); ++j) {
            if (!is_alone(scene, {piece, j}, level)) continue;
            ++alone;
            EXPECT_EQ(scene.curves.piece(piece).outline, 1);
        }
    }
    EXPECT_GT(alone, 5);
}

}  // namespace
}  // namespace touchline
