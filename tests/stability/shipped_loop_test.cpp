// The shipped loop on a wall and through torture geometry, in short; in full by
// tests/stability/run.

#include "haptics/servo/loop_settings.h"
#include "tests/stability/counter_noise.h"
#include "tests/stability/factorial.h"
#include "tests/stability/hands.h"
#include "tests/stability/scenario_loops.h"

#include <gtest/gtest.h>

namespace touchline::stability {
namespace {

template <class Case>
std::vector<Case> every(std::size_t stride, const std::vector<Case>& cases) {
    std::vector<Case> some;
    for (std::size_t i = 0; i < cases.size(); i += stride) some.push_back(cases[i]);
    return some;
}

TEST(ShippedLoop, AtItsDefaultsShakesForNoHandAndNoFaultUpToAPeriodOfDelay) {
    auto all = factorial({0.0, 0.5, 1.0});
    std::erase_if(all, [](const FactorialCase& each) { return each.is_stiffest; });
    const auto cases = every(53, all);
    const auto results = measure_all(cases);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        EXPECT_FALSE(results[i].is_through) << csv_line(cases[i], results[i]);
        EXPECT_FALSE(shakes(results[i])) << csv_line(cases[i], results[i]);
        // It is pressed at all.
        EXPECT_GT(results[i].bound_J, 0.0) << csv_line(cases[i], results[i]);
    }
}

TEST(ShippedLoop, LetsNothingThroughAndRingsNowhereOnTortureGeometry) {
    const auto cases = every(7, scenario_cases());
    const auto results = measure_all(cases);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const std::string line = csv_line(cases[i], results[i]);
        EXPECT_EQ(results[i].let_through, 0) << line;
        EXPECT_GT(results[i].handle_through, 0) << line;
        EXPECT_LE(results[i].extent_steps, 2.0) << line;
        EXPECT_LE(results[i].generated_J, results[i].bound_J + 1e-9) << line;
        EXPECT_GT(results[i].largest_N, 0.1) << line;
    }
}

TEST(ShippedLoop, DelayThatNobodyToldOfIsCut) {
    ShippedLoop loop;
    loop.profile = default_profile();
    loop.delay_s = 3e-3;
    loop.hand = light_hand;
    loop.stiffness_N_per_m = 900.0;
    TactileMap map;
    map.outlines.push_back({});
    map.outlines.back().points = {{-0.03, 0.0}, {0.03, 0.0}};
    const Scene scene = build_scene(map, {}, 0.0).value();
    const auto path = std::make_shared<WaypointPath>(
        std::vector<WaypointPath::Waypoint>{{0.9, {0.0, 0.01}}, {1.0, {0.0, -0.02}}});
    EXPECT_LT(run(loop, scene, path, 3.0).least_gain, 1.0);
    loop.delay_s = 1e-3;
    EXPECT_EQ(run(loop, scene, path, 3.0).least_gain, 1.0);
}

TEST(CounterNoise, IsEvenAndTheSameEverywhere) {
    double sum = 0.0;
    double squares = 0.0;
    constexpr int count = 100000;
    for (int i = 0; i < count; ++i) {
        const double noise = even_noise(7, static_cast<std::uint64_t>(i));
        ASSERT_GE(noise, 0.0);
        ASSERT_LT(noise, 1.0);
        sum += noise;
        squares += noise * noise;
    }
    EXPECT_NEAR(sum / count, 1.0 / 2.0, 0.003);
    EXPECT_NEAR(squares / count, 1.0 / 3.0, 0.003);
    // The first output of SplitMix64 from 0.
    EXPECT_EQ(even_noise(0, 0), static_cast<double>(0xe220a8397b1dcdafU >> 11) * 0x1.0p-53);
}

}  // namespace
}  // namespace touchline::stability
