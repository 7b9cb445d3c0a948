// S01 to S06 without S03: flat walls, valleys, polygonised circles, thin bars and swipes.
//
// The reference values of all scenarios come from an independent two-dimensional simulation
// (god-object, collide and slide) on the same plant: forces within 3 %, jumps within 10 %, counts
// exact. That simulation stops 1 nm short of what it touches; the machine keeps the radius exactly
// and, as a point, 10 pm.
#include "tests/haptics/contact/scenarios/runner.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace touchline::scenarios {
namespace {

TEST(Scenario, S01FlatWallPressSlideRelease) {
    const Scene scene = scene_of({flat_line()});
    const ScenarioRun felt = run(scene, press_and_slide(), 1.4);
    expect_forces(felt, 1.459, 0.0570);
    EXPECT_EQ(felt.watch.side_flips, 0);
    EXPECT_TRUE(is_within(felt.watch.work_J, 4.970e-5, 0.10));
    EXPECT_TRUE(is_within(felt.watch.allowed_J, 3.221e-3, 0.03));
    EXPECT_TRUE(is_within(tail_peak_to_peak_m(felt), 0.0229 * mm, 0.10));
}

struct Valley {
    double opening_deg, force_N;
};

class ScenarioS02 : public testing::TestWithParam<Valley> {};

TEST_P(ScenarioS02, ConcaveCornerHoldsTheHandAndLeavesItQuiet) {
    const double a = GetParam().opening_deg * pi / 360.0;
    const Position arm{50.0 * std::sin(a), 50.0 * std::cos(a)};
    const Scene scene = scene_of({{{{-arm.x, arm.y}, {0.0, 0.0}, arm}}});
    const auto wiggle = [](double t) -> Intention {
        constexpr double omega = 2.0 * pi * 3.0;
        const bool is_wiggling = t > 0.5 && t < 1.5;
        return {
            {is_wiggling ? 2 * mm * std::sin(omega * t) : 0.0,
             20 * mm - 25 * mm * std::min(t / 0.5, 1.0)},
            {is_wiggling ? 2 * mm * omega * std::cos(omega * t) : 0.0, t < 0.5 ? -50 * mm : 0.0}};
    };
    const ScenarioRun felt = run(scene, wiggle, 2.5);
    expect_forces(felt, GetParam().force_N, 0.0500);
    EXPECT_EQ(felt.watch.side_flips, 0);
    EXPECT_LE(largest_jump(felt).size_N, 0.06);
    EXPECT_LT(tail_peak_to_peak_m(felt), 1e-6);
    const auto escapes = std::count_if(felt.proxy.begin(), felt.proxy.end(), [a](Position p) {
        return std::abs(p.x) * std::cos(a) > p.y * std::sin(a) + 1e-7;
    });
    EXPECT_EQ(escapes, 0);
}

INSTANTIATE_TEST_SUITE_P(Openings, ScenarioS02,
                         testing::Values(Valley{90, 1.302}, Valley{60, 1.304}, Valley{30, 1.308},
                                         Valley{15, 1.323}, Valley{5, 1.490}));

struct Ripple {
    int vertices;
    double mean_N, jump_N, direction_deg, path_mm;
};

class ScenarioS04 : public testing::TestWithParam<Ripple> {};

TEST_P(ScenarioS04, PolygonisedCircleRipplesAsItsVerticesSay) {
    const Ripple expected = GetParam();
    const Scene scene = scene_of({polygon(30.0, expected.vertices)});
    const auto trace = [](double t) -> Intention {
        constexpr double omega = 0.1 / 0.03;
        const double r = 35 * mm - 10 * mm * std::min(t / 0.2, 1.0);
        const double a = omega * std::max(t - 0.2, 0.0);
        if (t <= 0.2) return {{r * std::cos(a), r * std::sin(a)}, {-50 * mm, 0.0}};
        return {{r * std::cos(a), r * std::sin(a)},
                {-r * omega * std::sin(a), r * omega * std::cos(a)}};
    };
    const ScenarioRun felt = run(scene, trace, 2.0);
    double sum_N = 0.0, direction_deg = 0.0;
    double nearest_m = 1.0, farthest_m = 0.0;
    for (std::size_t k = 600; k < felt.force.size(); ++k) {
        const double f = norm(felt.force[k]);
        const double r = norm(felt.hand[k]);
        sum_N += f;
        const double cosine = std::clamp(dot(felt.force[k], felt.hand[k]) / (f * r), -1.0, 1.0);
        direction_deg = std::max(direction_deg, std::acos(cosine) * 180.0 / pi);
        nearest_m = std::min(nearest_m, r);
        farthest_m = std::max(farthest_m, r);
    }
    EXPECT_TRUE(
        is_within(sum_N / static_cast<double>(felt.force.size() - 600), expected.mean_N, 0.03));
    EXPECT_TRUE(is_within(largest_jump(felt, 600).size_N, expected.jump_N, 0.10));
    EXPECT_LE(direction_deg, expected.direction_deg * 1.10);
    EXPECT_GE(direction_deg, 0.9 * 180.0 / expected.vertices);  // half of a vertex's turn at least
    EXPECT_TRUE(is_within((farthest_m - nearest_m) / mm, expected.path_mm, 0.10));
    EXPECT_EQ(felt.watch.side_flips, 0);
    expect_sound(felt.watch);
}

INSTANTIATE_TEST_SUITE_P(Vertices, ScenarioS04,
                         testing::Values(Ripple{16, 1.060, 0.4842, 11.83, 0.4989},
                                         Ripple{32, 1.112, 0.2535, 6.04, 0.1974},
                                         Ripple{64, 1.126, 0.1145, 3.11, 0.0077},
                                         Ripple{128, 1.130, 0.0563, 1.65, 0.0039},
                                         Ripple{256, 1.131, 0.0280, 0.92, 0.0033},
                                         Ripple{512, 1.131, 0.0140, 0.56, 0.0032}));

class ScenarioS05 : public testing::TestWithParam<double> {};

TEST_P(ScenarioS05, ThinBarIsNeverPoppedThrough) {
    const double width_mm = GetParam();
    const Scene scene =
        scene_of({{{{-20.0, 0.0}, {20.0, 0.0}, {20.0, -width_mm}, {-20.0, -width_mm}}, true}});
    const ScenarioRun felt = run(
        scene, through({{0, 0, 10}, {.5, 0, -8}, {1.0, 0, -8}, {1.5, 0, 10}, {1.7, 0, 10}}), 1.9);
    expect_forces(felt, 1.945, 0.0341);
    EXPECT_EQ(felt.watch.side_flips, 0);
    // Within 2 % of the most that sampling can give away.
    EXPECT_TRUE(is_within(felt.watch.work_J, 2.277e-5, 0.03));
    EXPECT_TRUE(is_within(felt.watch.allowed_J, 2.329e-5, 0.03));
    const auto pops = std::count_if(felt.proxy.begin(), felt.proxy.end(),
                                    [&](Position p) { return p.y < -0.5 * width_mm * mm; });
    EXPECT_EQ(pops, 0);
}

INSTANTIATE_TEST_SUITE_P(Widths, ScenarioS05, testing::Values(0.2, 0.5, 1.0, 3.0));

TEST(Scenario, S05ThinBarHoldsFiveNewtons) {
    const Scene scene =
        scene_of({{{{-20.0, 0.0}, {20.0, 0.0}, {20.0, -0.2}, {-20.0, -0.2}}, true}});
    // 300 N/m of hand in series with 1000 N/m of wall: 5 N at 21.7 mm.
    const ScenarioRun felt = run(scene, through({{0, 0, 10}, {1.0, 0, -24}}), 1.5);
    EXPECT_GT(largest_force_N(felt), 5.0);
    expect_sound(felt.watch);
    for (const Position p : felt.proxy) EXPECT_GE(p.y, 0.0);
}

TEST(Scenario, S06SwipeIsNeverMissed) {
    const Scene scene = scene_of({flat_line()});
    constexpr double slow_tick_s = 2e-3;
    int missed = 0;
    for (const double v : {0.1, 0.25, 0.5, 1.0, 3.0}) {
        for (int phase = 0; phase < 50; ++phase) {
            WatchedMachine contact(scene, CommonSetUp{}, {3 * mm, 20 * mm});
            const double step_m = v * slow_tick_s;
            for (double y = 20 * mm - phase / 50.0 * step_m; y > -20 * mm; y -= step_m) {
                missed += contact.step({3 * mm, y}).p_WP.y < 0.0 ? 1 : 0;
            }
            expect_sound(contact.watch());
        }
    }
    EXPECT_EQ(missed, 0);
}

}  // namespace
}  // namespace touchline::scenarios
