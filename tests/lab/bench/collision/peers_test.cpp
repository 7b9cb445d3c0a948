// The benchmark uses the other libraries rightly: their answers are those of brute force.
#include "tests/lab/bench/collision/peers.h"

#include "tests/lab/bench/collision/brute_force.h"
#include "tests/lab/bench/collision/motions.h"

#include <gtest/gtest.h>

namespace touchline::bench {
namespace {

template <class Structure>
class PeerOnCurves : public testing::Test {};

using Structures = testing::Types<RTree, AabbTree>;
TYPED_TEST_SUITE(PeerOnCurves, Structures);

TYPED_TEST(PeerOnCurves, FirstCrossingsAreThoseOfBruteForce) {
    for (const auto kind : {workload::Kind::radial, workload::Kind::fractal}) {
        const auto curve = workload::curve(kind, 4096);
        const BruteForce brute(curve);
        const TypeParam structure(curve);
        for (const auto& [from, to] : test_motions(curve, 3000)) {
            const auto expected = brute.first_crossing(from, to);
            const auto found = structure.first_crossing(from, to);
            ASSERT_EQ(found.has_value(), expected.has_value());
            if (found) {
                ASSERT_EQ(found->share, expected->share);
            }
        }
    }
}

TYPED_TEST(PeerOnCurves, NearestPointsAreThoseOfBruteForce) {
    for (const auto kind : {workload::Kind::radial, workload::Kind::fractal}) {
        const auto curve = workload::curve(kind, 4096);
        const BruteForce brute(curve);
        const TypeParam structure(curve);
        for (const auto& motion : test_motions(curve, 1000)) {
            ASSERT_NEAR(structure.nearest(motion.from).distance_m,
                        brute.nearest(motion.from).distance_m, 1e-14);
        }
    }
}

TEST(Box2dScene, RayCastsFromOutsideHitWhereBruteForceDoes) {
    for (const auto kind : {workload::Kind::radial, workload::Kind::fractal}) {
        const auto curve = workload::curve(kind, 512);
        const BruteForce brute(curve);
        const Inside is_inside(curve);
        const Box2dScene scene(curve);
        int differing = 0;
        int crossings = 0;
        for (const auto& [from, to] : test_motions(curve, 3000)) {
            const auto expected = brute.first_crossing(from, to);
            if (is_inside(from)) continue;
            const auto found = scene.first_crossing(from, to);
            crossings += expected ? 1 : 0;
            const bool is_same =
                found.has_value() == expected.has_value() &&
                (!found || norm(*found - (from + expected->share * (to - from))) < 1e-7);
            differing += is_same ? 0 : 1;
        }
        EXPECT_GT(crossings, 150);
        EXPECT_LE(differing, crossings / 100);  // single precision, and rays that graze
    }
}

TEST(Box2dScene, ThePressedDiscRestsOutside) {
    const auto curve = workload::curve(workload::Kind::radial, 512);
    Box2dScene scene(curve);
    const Inside is_inside(curve);
    const Position outward = curve[0];
    scene.reset(1.1 * outward);
    Position disc;
    for (int i = 0; i < 200; ++i) {
        disc = scene.step((1.1 - 0.0015 * std::min(i, 100)) * outward);
    }
    EXPECT_FALSE(is_inside(disc));
    EXPECT_NEAR(BruteForce(curve).nearest(disc).distance_m, 0.0005, 0.0001);
}

}  // namespace
}  // namespace touchline::bench
