// S10 to S13: ends of lines, doubled lines, very many very short pieces, gaps.
#include "app/visit/proxy_radius.h"
#include "tests/haptics/contact/scenarios/runner.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace touchline::scenarios {
namespace {

TEST(Scenario, S10OpenEndIsLeftAndComeBackToFromBelow) {
    const Scene scene = scene_of({{{{-60.0, 0.0}, {0.0, 0.0}}}});
    const ScenarioRun felt = run(scene,
                                 through({{0, -30, 10},
                                          {.2, -30, -6},
                                          {1.0, 15, -6},
                                          {1.2, 15, -6},
                                          {2.0, -30, -6},
                                          {2.2, -30, -6},
                                          {2.6, -30, 12},
                                          {3.0, -30, 12}}),
                                 3.2);
    EXPECT_TRUE(is_within(largest_force_N(felt), 2.876, 0.03));
    EXPECT_TRUE(is_within(largest_jump(felt, 0, 2).size_N, 1.396, 0.10));
    const Jump drop = largest_jump(felt);
    EXPECT_TRUE(is_within(drop.size_N, norm(felt.force[drop.tick]), 0.01));  // the whole force
    expect_sound(felt.watch);
    EXPECT_TRUE(is_within(felt.watch.work_J, -4.728e-3, 0.05));
    bool was_below = false;
    for (std::size_t k = 1; k < felt.proxy.size(); ++k) {
        const Position from = felt.proxy[k - 1];
        const Position to = felt.proxy[k];
        if ((from.y < 0.0) != (to.y < 0.0)) {
            EXPECT_GT(std::max(from.x, to.x), 0.0) << "side changed before the end, tick " << k;
        }
        was_below = was_below || (to.y < 0.0 && to.x < -20 * mm);
    }
    EXPECT_TRUE(was_below);
}

TEST(Scenario, S10ACapOf1Point4TimesTheIndentationTakesTheJumpAway) {
    CommonSetUp set_up;
    set_up.contact.radius_m = 2.1 * mm;
    const Scene scene = scene_of({{{{-60.0, 0.0}, {0.0, 0.0}}}}, set_up.contact.radius_m);
    const ScenarioRun felt =
        run(scene, through({{0, -30, 12}, {.2, -30, -3.9}, {1.0, 15, -3.9}, {1.2, 15, -3.9}}), 1.4,
            set_up);
    EXPECT_GE(set_up.contact.radius_m,
              1.4 * norm(felt.force[340]) / set_up.contact.stiffness_N_per_m);
    EXPECT_LE(largest_jump(felt, 350).size_N, 0.12);
    RecordProperty("jump_N", fmt::format("{:.4f}", largest_jump(felt, 350).size_N));
    expect_sound(felt.watch);
}

TEST(Scenario, S11DoubledEdgesFeelLikeOne) {
    const Scene once = scene_of({flat_line()});
    const Scene twice = scene_of({flat_line(), {{{50.0, 0.0}, {-50.0, 0.0}}}});
    const ScenarioRun a = run(once, press_and_slide(), 1.4);
    const ScenarioRun b = run(twice, press_and_slide(), 1.4);
    double largest_N = 0.0;
    for (std::size_t k = 0; k < a.force.size(); ++k) {
        largest_N = std::max(largest_N, norm(a.force[k] - b.force[k]));
    }
    EXPECT_LE(largest_N, 1e-9);
    expect_sound(b.watch);
}

TEST(Scenario, S12AHundredThousandPiecesFeelLikeOneLine) {
    const ScenarioRun once = run(scene_of({flat_line()}), press_and_slide(), 1.4);
    const ScenarioRun cut = run(scene_of({cut_line()}), press_and_slide(), 1.4);
    double largest_N = 0.0;
    for (std::size_t k = 0; k < once.force.size(); ++k) {
        largest_N = std::max(largest_N, norm(once.force[k] - cut.force[k]));
    }
    RecordProperty("difference_N", fmt::format("{:.3g}", largest_N));
    EXPECT_LE(largest_N, 1e-6);
    expect_sound(cut.watch);
}

TEST(Scenario, S13GapsNarrowerThanTheProxyAreClosed) {
    struct Gap {
        double width_mm;
        bool is_open;
    };

    const Gap gaps[] = {{1e-6, false}, {1e-3, false},  {1e-2, false},
                        {9e-2, false}, {1.1e-1, true}, {1.0, true}};
    for (const Gap& gap : gaps) {
        const double half = 0.5 * gap.width_mm;
        const Scene scene =
            scene_of({{{{-50.0, 0.0}, {-half, 0.0}}}, {{{half, 0.0}, {50.0, 0.0}}}});
        const ScenarioRun felt = run(scene, through({{0, 0, 10}, {.3, 0, -6}, {.8, 0, -6}}), 1.0);
        EXPECT_EQ(felt.proxy.back().y < 0.0, gap.is_open) << gap.width_mm << " mm";
        expect_sound(felt.watch);
    }
}

/// Presses the kiosk's proxy as a visitor does: into the corner of a box whose sides stop short of
/// it, and shakes it there.
TEST(Scenario, S13SidesThatEndShortOfTheirCornerHoldTheKiosksProxy) {
    CommonSetUp set_up;
    set_up.contact.radius_m = proxy_radius_m;
    for (const double short_mm : {0.0, 1e-3, 0.1, 0.5, 1.0}) {
        SCOPED_TRACE(fmt::format("{} mm short", short_mm));
        const Scene scene = scene_of({{{{-20.0, -20.0}, {20.0 - short_mm, -20.0}}},
                                      {{{20.0, 20.0}, {20.0, -20.0 + short_mm}}},
                                      {{{-20.0, 20.0}, {20.0, 20.0}}},
                                      {{{-20.0, 20.0}, {-20.0, -20.0}}}},
                                     set_up.contact.radius_m);
        WatchedMachine machine(scene, set_up, {0.0, 0.0});
        double most_out_m = -1.0;
        Force last;
        for (int k = 1; k <= 3000; ++k) {
            const double pressed_m = 30 * mm * std::min(1.0, k / 1500.0);
            const double shaken_m = k > 1500 ? 1.5 * mm * std::sin(k / 40.0) : 0.0;
            const ContactReport report = machine.step({pressed_m + shaken_m, -pressed_m});
            most_out_m = std::max({most_out_m, report.p_WP.x - 20 * mm, -20 * mm - report.p_WP.y});
            last = report.force;
        }
        EXPECT_LT(most_out_m, 0.0);
        EXPECT_GT(norm(last), 1.0) << "it is pressed against them";
        expect_sound(machine.watch());
    }
}

}  // namespace
}  // namespace touchline::scenarios
