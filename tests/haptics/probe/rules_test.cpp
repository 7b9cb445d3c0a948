// R2 to R6 of the research note: a peg in a slot, a bar on a bump, a hook on an end, a spin past a
// line, a wedge.

#include "config/types/angle.h"
#include "tests/haptics/probe/hands.h"
#include "tests/haptics/probe/swept_judge.h"
#include "tests/haptics/scenes.h"

#include <cmath>

#include <gtest/gtest.h>

namespace touchline {
namespace {

Outline open(std::vector<Position> points) {
    return scenes::outline(std::move(points), false);
}

/// Goes from one pose to another in so many steps.
ProbeReport go(ProbeProxy& proxy, const ProbePose& from, const ProbePose& to, int steps) {
    ProbeReport report;
    for (int k = 1; k <= steps; ++k) {
        report = proxy.step(from + (static_cast<double>(k) / steps) * (to - from), 0.0, {}, {});
    }
    return report;
}

void expect_balance(const ProbeReport& report) {
    Force force = report.force;
    double torque_Nm = report.torque_Nm;
    for (int i = 0; i < report.contact_count; ++i) {
        const ProbeContact& c = report.contacts[static_cast<std::size_t>(i)];
        force = force - along<Force>(c.normal, c.force_N);
        torque_Nm -= c.force_N * cross(c.place - report.pose.place(), c.normal);
    }
    EXPECT_NEAR(force.x, 0.0, 1e-6);
    EXPECT_NEAR(force.y, 0.0, 1e-6);
    EXPECT_NEAR(torque_Nm, 0.0, 1e-6 * 0.01);
}

TEST(ProbeRules, R2APegEntersItsSlotAndJamsWithABoundedTorque) {
    const Scene scene = scene_of_outlines({open({{-0.02, 0.0},
                                                 {-0.0011, 0.0},
                                                 {-0.0011, -0.01},
                                                 {0.0011, -0.01},
                                                 {0.0011, 0.0},
                                                 {0.02, 0.0}})});
    const ProbeShape peg = shape_of(probes::bar(0.006, 0.002));
    const SweptJudge judge(scene.curves, 0.0, peg.edges());
    for (const double tilt_deg : {0.0, 4.0, 12.0}) {
        ProbeProxy proxy;
        const double upright = radians(90.0);
        const ProbePose above{0.0, 0.006, upright + radians(tilt_deg)};
        proxy.reset(peg, scene, above, 0.0);
        (void)proxy.step(above, 0.0, {}, {});
        ProbePose in{0.0, -0.004, above.angle_rad};
        ProbeReport report = go(proxy, above, in, 1000);
        for (int k = 0; k < 200; ++k) report = proxy.step(in, 0.0, {}, {});
        EXPECT_GT(judge.distance_m(proxy.pose()), 1e-8) << tilt_deg;
        // At most what the turning spring can give at this tilt.
        const double most_Nm =
            turn_stiffness_Nm_per_rad(peg, 500.0) * radians(tilt_deg + 1.0) + 2e-3;
        EXPECT_LE(std::abs(report.torque_Nm), most_Nm) << tilt_deg;
        if (tilt_deg < 5.0) {
            EXPECT_LT(report.pose.y_m, -0.0035) << tilt_deg;
        }
        if (tilt_deg > 0.0) {
            EXPECT_GT(std::abs(report.torque_Nm), 1e-5) << tilt_deg;
        }
        const ProbePose settled = proxy.pose();
        for (int k = 0; k < 5000; ++k) report = proxy.step(in, 0.0, {}, {});
        EXPECT_LT(norm((proxy.pose() - settled).by), 1e-9) << tilt_deg;
    }
}

TEST(ProbeRules, R3ALongBarAcrossABumpRestsOnTwoPointsInBalance) {
    std::vector<Position> bump;
    for (int i = 0; i <= 400; ++i) {
        const double x = -0.04 + 0.08 * i / 400.0;
        bump.push_back({x, 0.004 * std::exp(-x * x / (0.006 * 0.006))});
    }
    const Scene scene = scene_of_outlines({open(bump)});
    const ProbeShape bar = shape_of(probes::bar(0.03, 0.002));
    ProbeProxy proxy;
    const ProbePose above{0.006, 0.012, 0.0};
    proxy.reset(bar, scene, above, 0.0);
    (void)proxy.step(above, 0.0, {}, {});
    const ProbePose pressed{0.006, -0.004, 0.0};
    ProbeReport report = go(proxy, above, pressed, 500);
    for (int k = 0; k < 500; ++k) report = proxy.step(pressed, 0.0, {}, {});
    EXPECT_EQ(report.contact_count, 2);
    EXPECT_GT(report.force.y, 1.0);
    EXPECT_GT(std::abs(report.torque_Nm), 1e-3);
    expect_balance(report);
}

TEST(ProbeRules, R4AnLHookedOnAnOpenEndHoldsAgainstTwoNewtons) {
    const Scene scene = scene_of_outlines({open({{0.0, 0.0}, {0.0, 0.02}})});
    // The short leg behind the line's lower end, the corner below it.
    const ProbeShape ell = shape_of(probes::ell(0.01, 0.002));
    ProbeProxy proxy;
    const ProbePose hooked{-0.005, -0.004, 0.0};
    proxy.reset(ell, scene, hooked, 0.0);
    ASSERT_TRUE(proxy.step(hooked, 0.0, {}, {}).is_placed);
    const ProbePose pulled{-0.005, 0.0, 0.0};  // 2 N upwards once the long leg holds
    ProbeReport report = go(proxy, hooked, pulled, 400);
    for (int k = 0; k < 1000; ++k) report = proxy.step(pulled, 0.0, {}, {});
    EXPECT_LT(report.force.y, -0.5);
    EXPECT_LT(report.pose.y_m, -0.001);
    const ProbePose settled = proxy.pose();
    for (int k = 0; k < 5000; ++k) report = proxy.step(pulled, 0.0, {}, {});
    EXPECT_LT(norm((proxy.pose() - settled).by), 1e-9);
    expect_balance(report);
}

TEST(ProbeRules, R5ASpinPastALineMissesNothing) {
    const Scene scene = scene_of_outlines({open({{0.015, -0.01}, {0.015, 0.01}})});
    const ProbeShape bar = shape_of(open({{-0.02, 0.0}, {0.02, 0.0}}));
    const SweptJudge judge(scene.curves, 0.0, bar.edges());
    for (int start = 0; start < 50; ++start) {
        ProbeProxy proxy;
        std::vector<ProbePose> path;
        const double angle = radians(70.0) + 1e-3 * start;
        proxy.reset(bar, scene, {0.0, 0.0, angle}, 0.0);
        (void)proxy.step({0.0, 0.0, angle}, 0.0, {}, {}, 2e-3);
        proxy.record_path(&path);
        ProbeReport report;
        for (int k = 1; k <= 60; ++k) {
            report = proxy.step({0.0, 0.0, angle - 0.02 * k}, 0.0, {}, {}, 2e-3);
            ASSERT_TRUE(judge.is_free(path)) << start << " " << k;
        }
        EXPECT_GT(std::abs(report.torque_Nm), 1e-3);
    }
}

TEST(ProbeRules, R6AWedgeHoldsWithAtMostThreeContactsAndDoesNotRing) {
    const Scene scene = scene_of_outlines({open({{-0.01, 0.02}, {0.0, 0.0}, {0.012, 0.02}}),
                                           open({{-0.006, 0.009}, {-0.001, 0.0165}})});
    const ProbeShape block = shape_of(probes::bar(0.006, 0.004));
    ProbeProxy proxy;
    const ProbePose above{0.002, 0.03, 0.2};
    proxy.reset(block, scene, above, 0.0);
    (void)proxy.step(above, 0.0, {}, {});
    const ProbePose in{0.0, 0.004, 0.2};
    ProbeReport report = go(proxy, above, in, 800);
    for (int k = 0; k < 500; ++k) report = proxy.step(in, 0.0, {}, {});
    EXPECT_GE(report.contact_count, 2);
    EXPECT_LE(report.contact_count, 3);
    expect_balance(report);
    // The hand's encoders flicker by a step of 20 um and 0.1 degrees: the tail stays within twice
    // that.
    ProbePose low = report.pose;
    ProbePose high = report.pose;
    for (int k = 0; k < 1000; ++k) {
        const double flicker = k % 2 == 0 ? 1.0 : 0.0;
        report = proxy.step(in + ProbeMove{{2e-5 * flicker, 0.0}, 1e-3 * flicker}, 0.0, {}, {});
        low = {std::min(low.x_m, report.pose.x_m), std::min(low.y_m, report.pose.y_m),
               std::min(low.angle_rad, report.pose.angle_rad)};
        high = {std::max(high.x_m, report.pose.x_m), std::max(high.y_m, report.pose.y_m),
                std::max(high.angle_rad, report.pose.angle_rad)};
    }
    EXPECT_LT(high.x_m - low.x_m, 4e-5);
    EXPECT_LT(high.y_m - low.y_m, 4e-5);
    EXPECT_LT(high.angle_rad - low.angle_rad, radians(0.1));
}

TEST(ProbeRules, AHandThatIsNotFiniteMovesNothing) {
    const Scene scene = scene_of_outlines({scenes::square(0.04, 4)});
    const ProbeShape bar = shape_of(probes::bar(0.01, 0.002));
    ProbeProxy proxy;
    proxy.reset(bar, scene, {}, 0.0);
    (void)proxy.step({0.03, 0.0, 0.0}, 0.0, {}, {});
    const ProbePose before = proxy.pose();
    const ProbeReport report = proxy.step({NAN, 0.0, 0.0}, 0.0, {}, {});
    EXPECT_EQ(report.force, (Force{}));
    EXPECT_EQ(report.torque_Nm, 0.0);
    EXPECT_EQ(proxy.pose(), before);
}

TEST(ProbeRules, AShapeOverALineWaitsUntilItIsClear) {
    const Scene scene = scene_of_outlines({scenes::square(0.04, 4)});
    const ProbeShape bar = shape_of(probes::bar(0.01, 0.002));
    ProbeProxy proxy;
    proxy.reset(bar, scene, {0.02, 0.0, 0.0}, 0.0);
    EXPECT_FALSE(proxy.step({0.02, 0.0, 0.0}, 0.0, {}, {}).is_placed);
    EXPECT_TRUE(proxy.step({0.01, 0.0, 0.0}, 0.0, {}, {}).is_placed);
    const ProbeReport report = proxy.step({0.02, 0.0, 0.0}, 0.0, {}, {});
    EXPECT_NEAR(report.pose.x_m, 0.015, 1e-6);
    EXPECT_NEAR(report.force.x, -500.0 * 0.005, 1e-3);
}

TEST(ProbeRules, TheBudgetIsKeptAndTheRestIsCarried) {
    const Scene scene = trials::scene_of(scenes::random_map(5, 5), 5);
    const ProbeShape shape = any_shape(3);
    Budget budget;
    budget.boxes = 40;
    RestlessHand hand(5);
    ProbeProxy proxy;
    proxy.reset(shape, scene, hand.step(), 0.0);
    bool is_cut = false;
    for (int k = 0; k < 3000; ++k) {
        const ProbeReport report = proxy.step(hand.step(), 0.0, {}, budget);
        ASSERT_LE(report.boxes, 40);
        is_cut = is_cut || report.clear < 1.0;
    }
    EXPECT_TRUE(is_cut);
    const ProbePose at = hand.step();
    for (int k = 0; k < 200; ++k) (void)proxy.step(at, 0.0, {}, budget);
    EXPECT_EQ(proxy.step(at, 0.0, {}, budget).clear, 1.0);
}

TEST(ProbeRules, AShapeIsPlacedWithTheSmallestBudget) {
    const Scene scene = trials::scene_of(scenes::random_map(5, 5), 5);
    const ProbeShape shape = any_shape(3);
    Budget budget;
    budget.boxes = 1;
    const ProbePose beside{0.07, 0.07, 0.0};
    ProbeProxy proxy;
    proxy.reset(shape, scene, beside, 0.0);
    for (int k = 0; k < 500; ++k) (void)proxy.step(beside, 0.0, {}, budget);
    EXPECT_TRUE(proxy.step(beside, 0.0, {}, budget).is_placed);
}

TEST(ProbeRules, ARoomOfWallsCostsLessThanAThousandBoxes) {
    const Scene scene = scene_of_outlines({scenes::square(0.0206, 500)});
    const ProbeShape shape = polygon(0.01, 64);
    ProbeProxy proxy;
    proxy.reset(shape, scene, {}, 0.0);
    (void)proxy.step({}, 0.0, {}, {});
    int most = 0;
    for (int k = 0; k < 3000; ++k) {
        const double t = 1e-3 * k;
        const ProbePose hand{0.004 * std::sin(7.0 * t), 0.004 * std::sin(5.0 * t), 3.0 * t};
        const ProbeReport report = proxy.step(hand, 0.0, {}, {});
        ASSERT_TRUE(report.is_placed);
        most = std::max(most, report.boxes);
    }
    EXPECT_LT(most, 1000);
    RecordProperty("boxes", most);
}

}  // namespace
}  // namespace touchline
