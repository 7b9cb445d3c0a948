// Boxes hold everything that they claim. Every node of every level holds the points of all finer
// levels, and of the blends between them, over the node's stretch.
#include "haptics/collision/scene.h"
#include "tests/haptics/collision/trials.h"
#include "tests/haptics/scenes.h"
#include "tests/lab/bench/workload.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

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

/// A walk of nodes with their boxes, some without length, of edges from 1 nm to 1 mm.
struct Walk {
    std::vector<Position> points;
    std::vector<PackedExtents> extents;

    Walk(trials::Random& random, std::size_t nodes) {
        Position at = random.place();
        const double edge_m = random.decade(-9.0, -3.0);
        const double sharpness = random.unit() < 0.5 ? 0.2 : 6.0;
        double angle = 6.0 * random.unit();
        for (std::size_t i = 0; i <= nodes; ++i) {
            points.push_back(at);
            angle += sharpness * (random.unit() - 0.5);
            const double length_m = random.below(20) == 0 ? 0.0 : edge_m * (0.2 + random.unit());
            at += length_m * Position{std::cos(angle), std::sin(angle)};
            const auto beyond = [&] { return random.below(3) == 0 ? 0.0 : random.decade(-4, 0.5); };
            extents.emplace_back(-beyond(), 1.0 + beyond(), -beyond(), beyond());
        }
    }

    [[nodiscard]] Box box(std::size_t j, bool is_bare) const {
        const Segment s{points[j], points[j + 1]};
        return is_bare ? box_of(s) : box_of(s, extents[j]);
    }
};

/// A way of 1 nm to 10 mm that starts near a place.
Way way_near(trials::Random& random, Position place) {
    const Position from = place + random.decade(-9.0, -2.0) * random.direction();
    return {from, random.decade(-9.0, -2.0) * random.direction(), random.decade(-11.0, -3.0)};
}

TEST(Boxes, AReadyFanLeavesOutOnlyWhatAWayDoesNotMeet) {
    trials::Random random(38);
    int met = 0;
    int sifted = 0;
    int missed = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        const Walk walk(random, Fan::width);
        const bool is_bare = random.below(2) == 0;
        const int count = 1 + static_cast<int>(random.below(Fan::width));
        const Fan fan{walk.points.data(), is_bare ? nullptr : walk.extents.data(), count};
        const Way way = way_near(random, walk.points[random.below(Fan::width)]);
        const Sifted found = sift(ready(fan), way);
        EXPECT_EQ(found.near >> count, 0U);
        for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
            const Approach exact = approach(walk.box(k, is_bare), way);
            const bool is_near = (found.near >> k & 1U) != 0;
            met += exact.is_met ? 1 : 0;
            sifted += is_near ? 0 : 1;
            missed += exact.is_met && !is_near ? 1 : 0;
            const double entry = exact.is_met ? exact.entry : 1.0;
            if (is_near) {
                EXPECT_LE(found.key[k], 1.0001 * entry + 1e-5);
            } else {
                EXPECT_LE(found.gap2_m2, 1.0001 * exact.gap2_m2);
            }
        }
    }
    EXPECT_EQ(missed, 0);
    EXPECT_GT(met, 5000);
    EXPECT_GT(sifted, 5000);
}

TEST(Boxes, ThoseFurtherAlongAreSiftedOutOnlyWhereTheyAreApart) {
    constexpr std::size_t fours = 8;
    trials::Random random(36);
    int apart = 0;
    int sifted = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const Walk walk(random, Fan::width * (fours + 1));
        const bool is_bare = trial % 2 == 0;
        const double reach_m = random.decade(-11.0, -3.0);
        std::array<Apart, fours> found;
        sift_ahead(walk.points.data(), is_bare ? nullptr : walk.extents.data(), reach_m, found);
        const auto look_at = [&](unsigned bits, std::size_t k, std::size_t j, std::size_t ahead) {
            const bool is_sifted = (bits >> k & 1U) != 0;
            const bool is_met =
                overlap(walk.box(j, is_bare), walk.box(j + ahead, is_bare), reach_m);
            apart += is_met ? 0 : 1;
            sifted += is_sifted ? 1 : 0;
            EXPECT_FALSE(is_sifted && is_met) << trial << " " << j << " " << ahead;
        };
        for (std::size_t j = 0; j < Fan::width * fours; ++j) {
            const std::size_t k = j % Fan::width;
            look_at(found[j / Fan::width].by_two, k, j, 2);
            if (k % 2 == 0) look_at(found[j / Fan::width].by_three, k, j, 3);
        }
    }
    EXPECT_GT(sifted, apart * 9 / 10);
    EXPECT_GT(apart, 10000);
}

TEST(Boxes, ExtentsArePackedOutwardByLessThanOnePercent) {
    trials::Random random(7);
    for (int trial = 0; trial < 100000; ++trial) {
        const auto any = [&] {
            const double x = random.decade(-45.0, 37.0);
            return random.below(2) == 0 ? x : static_cast<double>(static_cast<float>(x));
        };
        const double low = random.below(10) == 0 ? 0.0 : -any();
        const double high = random.below(10) == 0 ? 0.0 : any();
        const PackedExtents packed(low, high, -high, -low);
        for (const auto& [held, by] :
             {std::pair(low, packed.along_low()), std::pair(-high, packed.across_low())}) {
            EXPECT_LE(by, held);
            EXPECT_GE(by, 1.01 * held - 1e-38);
        }
        EXPECT_EQ(packed.along_high(), -packed.across_low());
        EXPECT_EQ(packed.across_high(), -packed.along_low());
    }
}

}  // namespace
}  // namespace touchline
