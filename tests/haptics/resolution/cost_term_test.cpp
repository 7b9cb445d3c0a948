#include "haptics/resolution/level_rule.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

constexpr double period_s = 1e-3;

/// Does the same work for a while, rendered at the level that the term asks for. Returns the last
/// level.
double run(CostTerm& cost, const Work& work, double seconds) {
    for (int i = 0; i < std::lround(seconds / period_s); ++i) (void)cost.step(work, cost.level());
    return cost.level();
}

const Work cut{1, true};

/// Cuts ticks for as long as it takes to coarsen.
void overload(CostTerm& cost, double rendered_level) {
    for (int i = 0; i < 4; ++i) (void)cost.step(cut, rendered_level);
}

TEST(Work, IsCutWhereSomethingIsLeftOrUnproven) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    ContactReport report;
    report.boxes = 7;
    EXPECT_EQ(work_of(report).boxes, 7);
    EXPECT_FALSE(work_of(report).is_cut);
    for (const double left : {1e-6, nan}) {
        report.carried_m = left;
        EXPECT_TRUE(work_of(report).is_cut);
    }
    report.carried_m = 0.0;
    for (const double clear : {0.0, 0.99, nan}) {
        report.clear = clear;
        EXPECT_TRUE(work_of(report).is_cut);
    }
}

TEST(CostTerm, AffordsAShareOfThePeriod) {
    EXPECT_GT(affordable_boxes(1e-3), 1000);
    EXPECT_EQ(affordable_boxes(2e-3), 2 * affordable_boxes(1e-3));
    EXPECT_EQ(affordable_boxes(1e9), std::numeric_limits<int>::max());
    EXPECT_LT(affordable_boxes(2.5e-4) * 50e-9, 0.3 * 2.5e-4 + 50e-9);
}

TEST(CostTerm, CoarsensAtOnceFromTheLevelThatWasRendered) {
    CostTerm cost(period_s);
    const int affordable = affordable_boxes(period_s);
    EXPECT_EQ(cost.step({affordable, false}, 0.0), 0.0);
    EXPECT_EQ(cost.step({affordable + 1, false}, 0.0), 1.0);
    EXPECT_EQ(cost.step({affordable + 1, false}, 3.0), 4.0);
    EXPECT_EQ(cost.step({affordable + 1, false}, 4.4), 5.0);
}

TEST(CostTerm, FourTicksCutInARowAreTooMuchHoweverFewBoxesTheyOpened) {
    CostTerm cost(period_s);
    for (int i = 0; i < 50; ++i) {  // makes up in time for what is left over
        for (int k = 0; k < 3; ++k) EXPECT_EQ(cost.step(cut, 0.0), 0.0);
        EXPECT_EQ(cost.step({1, false}, 0.0), 0.0);
    }
    for (int k = 0; k < 3; ++k) EXPECT_EQ(cost.step(cut, 0.0), 0.0);
    EXPECT_EQ(cost.step(cut, 0.0), 1.0);
    for (int k = 0; k < 3; ++k) EXPECT_EQ(cost.step(cut, 1.0), 1.0);
    EXPECT_EQ(cost.step(cut, 1.0), 2.0);
}

TEST(CostTerm, WaitsForTheLevelToBeRenderedBeforeItCoarsensFurther) {
    const Work over{affordable_boxes(period_s) + 1, false};
    CostTerm cost(period_s);
    for (int i = 0; i < 50; ++i) EXPECT_EQ(cost.step(over, 0.0), 1.0);
    EXPECT_EQ(cost.step(over, 0.6), 1.0);
    EXPECT_EQ(cost.step(over, 1.0), 2.0);
}

TEST(CostTerm, RefinesALevelEachHalfSecondOnceTheWorkIsGone) {
    CostTerm cost(period_s);
    overload(cost, 2.0);
    EXPECT_EQ(run(cost, {10, false}, 0.49), 3.0);
    EXPECT_EQ(run(cost, {10, false}, 0.02), 2.0);
    EXPECT_EQ(run(cost, {10, false}, 0.48), 2.0);
    EXPECT_EQ(run(cost, {10, false}, 0.03), 1.0);
    EXPECT_EQ(run(cost, {10, false}, 9.0), 0.0);
}

TEST(CostTerm, RefinesOnlyWhereTwiceTheMostOfTheLast64TicksIsAffordable) {
    const int half = affordable_boxes(period_s) / 2;
    CostTerm cost(period_s);
    overload(cost, 0.0);
    EXPECT_EQ(run(cost, {half + 1, false}, 5.0), 1.0);
    for (int i = 0; i < 50; ++i) {  // one expensive tick in 60 is enough
        (void)cost.step({half + 1, false}, 1.0);
        EXPECT_EQ(run(cost, {0, false}, 0.059), 1.0);
    }
    for (int i = 0; i < 50; ++i) {  // so is one that was cut
        (void)cost.step(cut, 1.0);
        EXPECT_EQ(run(cost, {0, false}, 0.059), 1.0);
    }
    EXPECT_EQ(run(cost, {half, false}, 0.08), 0.0);
}

TEST(CostTerm, ReckonsWithTwiceTheWorkForEachLevelBelowTheRenderedOne) {
    const int eighth = affordable_boxes(period_s) / 8;
    CostTerm cost(period_s);
    overload(cost, 1.0);  // l_cost 2, the hand's speed asks for 5: level 1 is 4 below
    for (int i = 0; i < 2000; ++i) EXPECT_EQ(cost.step({eighth, false}, 5.0), 2.0);
    EXPECT_EQ(cost.step({eighth / 2, false}, 5.0), 2.0);
    for (int i = 0; i < 80; ++i) (void)cost.step({eighth / 2, false}, 5.0);
    EXPECT_EQ(cost.level(), 1.0);
}

TEST(CostTerm, TriesLessAndLessOftenWhatDidNotLastAndAgainSoonAfterOneThatDid) {
    CostTerm cost(period_s);
    int refinements = 0;
    const auto flicker = [&](double seconds) {  // level 0 is cut, level 1 is not
        refinements = 0;
        for (int i = 0; i < std::lround(seconds / period_s); ++i) {
            const double before = cost.level();
            (void)cost.step({1, before < 1.0}, before);
            refinements += cost.level() < before ? 1 : 0;
        }
        return refinements;
    };
    EXPECT_EQ(flicker(0.9 + 0.5 + 1.0 + 2.0 + 4.0 + 8.0), 5);
    EXPECT_EQ(flicker(80.0), 10);
    EXPECT_EQ(run(cost, {1, false}, 20.0), 0.0);
    EXPECT_EQ(flicker(0.6), 1);
}

/// The work halves with each level, at any speed of the hand: the term ends at the finest
/// affordable level or the next coarser, and hardly moves after that.
RC_GTEST_PROP(CostTerm, SettlesAtAnAffordableLevel, ()) {
    const double rate_s = *rc::gen::element(2.5e-4, 1e-3, 2e-3);
    const double affordable = affordable_boxes(rate_s);
    const double finest_work = affordable * *rc::gen::inRange(1, 4000) / 100.0;
    const auto work_at = [&](double level) {
        return Work{static_cast<int>(finest_work * std::exp2(-level)), false};
    };
    CostTerm cost(rate_s);
    int changes = 0;
    for (int i = 0; i < std::lround(30.0 / rate_s); ++i) {
        const double before = cost.level();
        (void)cost.step(work_at(before), before);
        changes += cost.level() != before ? 1 : 0;
    }
    const double level = cost.level();
    RC_ASSERT(work_at(level).boxes <= affordable);
    RC_ASSERT(level == 0.0 || work_at(level - 1.0).boxes > affordable);
    // Boxes are whole: twice a level's work may look affordable where the next finer level is not.
    const bool is_tried_again = 2 * work_at(level).boxes <= affordable;
    RC_ASSERT(changes == static_cast<int>(level) || is_tried_again);
}

TEST(CostTerm, ALevelThatIsNoNumberChangesNothing) {
    CostTerm cost(period_s);
    overload(cost, std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(cost.level(), 0.0);
}

}  // namespace
}  // namespace touchline
