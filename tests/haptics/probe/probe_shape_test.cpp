// Which shapes are valid, that every node of the tree holds what is below it, and that the way
// recorded of a move is its way.

#include "haptics/probe/probe_shape.h"

#include "tests/haptics/probe/hands.h"
#include "tests/haptics/scenes.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(ProbeShape, TellsWhatCannotBeOne) {
    EXPECT_FALSE(ProbeShape::build({}, 0.0));
    EXPECT_FALSE(ProbeShape::build({{{0.0, 0.0}, {0.11, 0.0}}}, 0.0));
    EXPECT_FALSE(ProbeShape::build({{{0.0, 0.0}, {NAN, 0.0}}}, 0.0));
    EXPECT_FALSE(ProbeShape::build({{{0.0, 0.0}, {0.01, 0.0}}}, -1.0));
    EXPECT_FALSE(ProbeShape::build({{{0.0, 0.0}, {0.01, 0.0}}}, NAN));
    EXPECT_FALSE(ProbeShape::build(std::vector<Segment>(most_probe_edges + 1), 0.0));
    EXPECT_FALSE(ProbeShape::of_map({}, 0.0));
    EXPECT_TRUE(ProbeShape::build({{{0.0, 0.0}, {0.01, 0.0}}}, 0.001));
}

TEST(ProbeShape, IsAsLargeAsItsFurthestPoint) {
    EXPECT_DOUBLE_EQ(shape_of(probes::bar(0.06, 0.08)).r_max_m(), 0.05);
    EXPECT_EQ(shape_of(probes::bar(0.06, 0.08)).edges().size(), 4U);
    EXPECT_EQ(probes::disc(0.002).r_max_m(), 0.0);
}

TEST(ProbeShape, EveryNodeHoldsItsEdges) {
    for (std::size_t number = 0; number < 6; ++number) {
        const ProbeShape shape = any_shape(number);
        std::size_t leaves = 0;
        const std::function<std::vector<Segment>(std::int32_t)> check = [&](std::int32_t at) {
            const ProbeNode& node = shape.nodes()[static_cast<std::size_t>(at)];
            std::vector<Segment> held;
            if (node.edge >= 0) {
                ++leaves;
                held.push_back(shape.edges()[static_cast<std::size_t>(node.edge)]);
            } else {
                held = check(node.left);
                const auto right = check(node.left + 1);
                held.insert(held.end(), right.begin(), right.end());
            }
            for (const Segment& s : held) {
                for (const Position p : {s.a, s.b}) {
                    EXPECT_LE(scenes::distance_m(p, node.capsule.chord),
                              node.capsule.thickness_m + 1e-12);
                }
            }
            return held;
        };
        (void)check(0);
        EXPECT_EQ(leaves, shape.edges().size());
    }
}

TEST(ProbeMove, ItsRecordedWayIsWithinANanometre) {
    trials::Random random(5);
    std::size_t most = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const auto place = [&random](double size_m) {
            return Position{size_m * (random.unit() - 0.5), size_m * (random.unit() - 0.5)};
        };
        const ProbePose from{0.01 * random.unit(), 0.0, 6.0 * random.unit()};
        const ProbeMove move{place(1e-3), 0.4 * (random.unit() - 0.5), place(0.04)};
        std::vector<ProbePose> way{from};
        add_way(from, move, way);
        ASSERT_EQ(way.back(), from + move);
        const std::size_t parts = way.size() - 1;
        most = std::max(most, parts);
        for (std::size_t i = 0; i < parts; ++i) {
            for (const double share : {0.0, 0.25, 0.5, 0.75}) {
                const double done = (static_cast<double>(i) + share) / static_cast<double>(parts);
                const ProbeMove off =
                    (way[i] + share * (way[i + 1] - way[i])) - (from + done * move);
                // The angles agree, so every point of the shape is as far off as its origin.
                ASSERT_LT(norm(off.by), 1e-9) << trial;
                ASSERT_LT(std::abs(off.turn_rad), 1e-14) << trial;
            }
        }
    }
    EXPECT_GT(most, 100U);
}

TEST(Rotation, IsRightWhereItIsASeriesAndWhereNot) {
    for (double angle_rad = -0.3; angle_rad <= 0.3; angle_rad += 1e-3) {
        const Position turned = Rotation(angle_rad)(Position{1.0, 0.0});
        EXPECT_NEAR(turned.x, std::cos(angle_rad), 3e-16) << angle_rad;
        EXPECT_NEAR(turned.y, std::sin(angle_rad), 3e-16) << angle_rad;
    }
    EXPECT_TRUE(std::isnan(Rotation(NAN)(Position{1.0, 0.0}).x));
}

TEST(ProbePlacement, AfterAMoveIsThatOfThePoseAfterIt) {
    const ProbePose from{0.03, -0.02, 1.2};
    for (const double turn_rad : {0.0, 1e-9, -0.1, 0.7, 3.0}) {
        const ProbeMove move{{2e-4, -3e-4}, turn_rad, {0.004, 0.001}};
        const Position corner{0.005, -0.003};
        const Position after = ProbePlacement(from).after(move)(corner);
        EXPECT_NEAR(norm(after - ProbePlacement(from + move)(corner)), 0.0, 1e-17) << turn_rad;
    }
}

}  // namespace
}  // namespace touchline
