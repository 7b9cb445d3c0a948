// The shipped loop on a wall and through torture geometry, in short; tests/lab/stability/run does
// all of it.

#include "tests/lab/stability/shipped_loop.h"

#include "haptics/servo/loop_settings.h"
#include "tests/lab/stability/factorial.h"
#include "tests/lab/stability/hands.h"

#include <algorithm>

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
        // The hand does press.
        EXPECT_GT(results[i].bound_J, 0.0) << csv_line(cases[i], results[i]);
    }
}

TEST(ShippedLoop, LetsNothingThroughAndRingsNowhereOnTortureGeometry) {
    const auto cases = every(11, scenario_cases(0, 1.0));
    const auto results = measure_all(cases);
    std::size_t beyond_the_line = 0;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const std::string line = csv_line(cases[i], results[i]);
        EXPECT_EQ(results[i].let_through, 0) << line;
        EXPECT_FALSE(buzzes(results[i])) << line;
        EXPECT_LE(results[i].generated_J, results[i].bound_J + 1e-9) << line;
        if (results[i].handle_through > 0) ++beyond_the_line;
    }
    // Nearly every hand presses in.
    EXPECT_GT(beyond_the_line, cases.size() * 3 / 4);
}

TEST(ShippedLoop, IsNotCutWhereItsMotorsSaturate) {
    auto cases = scenario_cases(0, 1.0);
    std::erase_if(cases, [](const ScenarioCase& each) {
        const std::string& group = loop_scenarios()[each.scenario].torture.group;
        return group != "thin bars" || (each.hand != "normal" && each.hand != "stiff arm");
    });
    const auto results = measure_all(cases);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        EXPECT_GT(results[i].largest_N, 2.0);  // less than the hand's 5 N
        EXPECT_EQ(results[i].least_gain, 1.0) << csv_line(cases[i], results[i]);
    }
}

TEST(PlainLoops, FailWhereTheShippedOneDoesNot) {
    const auto share = [](std::size_t method, double asked, const auto& is_bad) {
        const auto cases = every(47, scenario_cases(method, asked));
        const auto results = measure_all(cases);
        return static_cast<double>(std::count_if(results.begin(), results.end(), is_bad)) /
               static_cast<double>(cases.size());
    };
    const auto is_through = [](const ScenarioResult& result) { return result.let_through > 0; };
    EXPECT_GT(share(1, 1.0, is_through), 0.3);  // it has no memory
    EXPECT_EQ(share(3, 1.0, is_through), 0.0);
    EXPECT_GT(share(3, 2.0, buzzes), 0.0);  // nothing limits its stiffness
    EXPECT_EQ(share(0, 2.0, buzzes), 0.0);
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
