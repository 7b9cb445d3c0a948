// Which shapes are valid, and that every node of the tree holds what is below it.

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

}  // namespace
}  // namespace touchline
