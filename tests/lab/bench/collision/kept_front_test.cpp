#include "tests/lab/bench/collision/kept_front.h"

#include "tests/lab/bench/workload.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace touchline::bench {
namespace {

struct Case {
    workload::Kind kind;
    std::size_t edges;
    KeptFront::Options options;
};

Scene scene_of(const Case& c) {
    return build_scene(workload::map_of(workload::curve(c.kind, c.edges)), {}, 0.0).value();
}

class KeptFrontOnTheHand : public testing::TestWithParam<Case> {};

TEST_P(KeptFrontOnTheHand, FindsTheHitsOfTheCollisionTree) {
    const Case& c = GetParam();
    const Scene scene = scene_of(c);
    const auto way = workload::hand(c.kind);
    KeptFront front(scene, c.options);
    front.place(way[0]);
    int hits = 0;
    for (std::size_t i = 1; i < way.size(); ++i) {
        const Hit found = front.first_hit(way[i]);
        const Motion motion{
            way[i - 1], way[i], c.options.radius_m, static_cast<double>(c.options.level), {}};
        const Hit expected = scene.tree.first_hit(scene.curves, motion, {});
        ASSERT_EQ(found.is_hit, expected.is_hit) << i;
        ASSERT_EQ(found.clear, expected.clear) << i;
        if (!expected.is_hit) continue;
        ++hits;
        ASSERT_EQ(found.segment, expected.segment) << i;
        ASSERT_EQ(found.touch.fraction, expected.touch.fraction) << i;
        ASSERT_EQ(found.touch.parameter, expected.touch.parameter) << i;
    }
    EXPECT_GT(hits, 200);
}

TEST_P(KeptFrontOnTheHand, IsThePapersBoundarySectionWithoutScheduleAndMargin) {
    const Case& c = GetParam();
    const Scene scene = scene_of(c);
    const auto way = workload::hand(c.kind, 20000);
    KeptFront::Options options = c.options;
    options.is_scheduled = false;
    options.margin_m = 0.0;
    KeptFront front(scene, options);
    front.place(way[0]);
    std::size_t largest = 0;
    for (std::size_t i = 1; i < way.size(); ++i) {
        (void)front.first_hit(way[i]);
        if (i % 10 != 0) continue;
        std::vector<ErrorBox> section;
        scene.tree.boundary_section(scene.curves, way[i], options.level, section);
        std::vector<FrontNode> expected;
        for (const ErrorBox& box : section) expected.push_back({box.piece, box.level, box.index});
        std::vector<FrontNode> found = front.front();
        std::sort(found.begin(), found.end());
        std::sort(expected.begin(), expected.end());
        ASSERT_EQ(found, expected) << i;
        largest = std::max(largest, found.size());
    }
    EXPECT_GT(largest, 12U);
}

constexpr double margin_m = 5e-4;

INSTANTIATE_TEST_SUITE_P(
    Curves, KeptFrontOnTheHand,
    testing::Values(Case{workload::Kind::radial, 4096, {0, contact_skin_m, margin_m, true}},
                    Case{workload::Kind::fractal, 8192, {0, contact_skin_m, margin_m, true}},
                    Case{workload::Kind::fractal, 8192, {2, contact_skin_m, 0.0, true}},
                    Case{workload::Kind::radial, 4096, {3, contact_skin_m, margin_m, false}}));

}  // namespace
}  // namespace touchline::bench
