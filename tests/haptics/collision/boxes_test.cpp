// Boxes hold everything that they claim. Every node of every level holds the points of all finer
// levels, and of the blends between them, over the node's stretch.
#include "haptics/collision/scene.h"
#include "tests/haptics/collision/trials.h"
#include "tests/haptics/scenes.h"
#include "tests/lab/bench/workload.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace touchline {
namespace {

/// Returns how far p lies outside a box of counter-clockwise corners; at most 0 inside.
double outside_m(const ErrorBox& box, Position p) {
    double worst = -INFINITY;
    for (std::size_t k = 0; k < 4; ++k) {
        const Position side = box.corners[(k + 1) % 4] - box.corners[k];
        const double length_m = norm(side);
        if (length_m > 0.0) worst = std::max(worst, -cross(side, p - box.corners[k]) / length_m);
    }
    return worst;
}

/// Corners are rounded when computed; queries widen boxes by 100 times as much.
constexpr double rounding_m = 1e-15;

struct Count {
    std::size_t nodes = 0;
    std::size_t points = 0;
    std::size_t outside = 0;
};

/// Checks the points of the piece as rendered at `level`, over one segment of the box's whole
/// level.
void check_node(const Scene& scene, const ErrorBox& box, double level, Count& count) {
    const RenderedPiece rendered = scene.curves.rendered(box.piece, level);
    const int stride = 1 << (box.level - static_cast<int>(level));
    const int last = std::min((box.index + 1) * stride, rendered.segment_count());
    for (int i = box.index * stride; i < last; ++i) {
        const Segment s = rendered.segment(i);
        for (const Position p : {s.a, s.b}) {
            ++count.points;
            count.outside += outside_m(box, p) > rounding_m ? 1U : 0U;
        }
    }
}

Count check(const Scene& scene) {
    Count count;
    for (int piece = 0; piece < static_cast<int>(scene.curves.pieces().size()); ++piece) {
        const int coarsest = scene.curves.pieces()[static_cast<std::size_t>(piece)].coarsest;
        for (int level = 0; level <= coarsest; ++level) {
            for (int j = 0; j < scene.curves.segment_count(piece, level); ++j) {
                const ErrorBox box = scene.tree.box(scene.curves, piece, level, j);
                ++count.nodes;
                check_node(scene, box, level, count);
                for (int finer = 0; finer < level; ++finer) {
                    for (const double part : {0.0, 0.1, 0.5, 0.9}) {
                        check_node(scene, box, finer + part, count);
                    }
                }
            }
        }
    }
    return count;
}

void expect_held(const Count& count) {
    fmt::print("  {} nodes, {} points, {} outside\n", count.nodes, count.points, count.outside);
    EXPECT_EQ(count.outside, 0U);
    EXPECT_GT(count.points, count.nodes);
}

TEST(Boxes, HoldEveryFinerLevelOfFourThousandSegments) {
    for (const auto kind : {workload::Kind::radial, workload::Kind::fractal}) {
        const TactileMap map = workload::map_of(workload::curve(kind, 4096));
        expect_held(check(trials::every_level(map)));
    }
}

TEST(Boxes, HoldEveryFinerLevelOfRandomOutlines) {
    Count all;
    for (std::uint64_t seed = 0; seed < trials::count(300, 10000); ++seed) {
        trials::Random random(seed);
        const TactileMap map = seed % 3 == 0 ? scenes::random_map(static_cast<unsigned>(seed), 4)
                                             : trials::small_map(random);
        const Count count = check(trials::scene_of(map, seed));
        all = {all.nodes + count.nodes, all.points + count.points, all.outside + count.outside};
    }
    expect_held(all);
}

}  // namespace
}  // namespace touchline
