// The eigenvalue limits against the reference tables, and theory against the eigenvalues.

#include "tests/lab/stability/linear_loop.h"

#include "tests/lab/stability/hands.h"
#include "tests/lab/stability/limits.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace touchline::stability {
namespace {

double limit(const TipParameters& tip, const HandModel& hand, const SampledWall& wall) {
    return LinearLoop(tip, hand, wall).largest_stiffness();
}

TEST(EigenvalueLimits, OfASpringAreTheReferenceTables) {
    struct Row {
        double mass_kg, b_Ns_per_m, period_s;
        double limits[5];  // at t_d = 0, T/2, T, 2T, 5T
    };

    constexpr double delays[] = {0.0, 0.5, 1.0, 2.0, 5.0};
    const Row rows[] = {
        {0.05, 0.1, 2e-3, {100.07, 50.04, 33.37, 20.04, 9.124}},
        {0.05, 0.1, 1e-3, {200.07, 100.04, 66.70, 40.04, 18.22}},
        {0.05, 0.5, 2e-3, {501.67, 251.04, 167.59, 100.86, 46.28}},
        {0.05, 0.5, 1e-3, {1001.67, 501.04, 334.26, 200.86, 91.74}},
        {0.05, 0.5, 2.5e-4, {4001.67, 2001.04, 1334.26, 800.87, 364.47}},
        {0.20, 2.0, 2e-3, {2006.69, 1004.15, 670.35, 403.43, 185.10}},
        {0.20, 5.0, 2e-3, {5042.02, 2525.73, 1689.47, 1021.10, 474.34}},
        {0.05, 5.0, 2e-3, {5172.30, 2600.0, 1753.85, 1078.0, 521.4}},
    };
    for (const Row& row : rows) {
        for (int i = 0; i < 5; ++i) {
            const double found = limit({row.mass_kg, row.b_Ns_per_m, 0.0}, no_hand,
                                       {row.period_s, delays[i] * row.period_s});
            EXPECT_NEAR(found, row.limits[i], 0.005 * row.limits[i])
                << row.mass_kg << " kg, delay " << delays[i] << " T";
        }
    }
}

TEST(EigenvalueLimits, AreAboveTheLinearFormulaAndNearIt) {
    for (const double mass_kg : {0.05, 0.2, 0.6}) {
        for (const double b : {0.1, 0.5, 2.0, 5.0}) {
            for (const double period_s : {2e-3, 1e-3, 2.5e-4}) {
                for (const double delay : {0.0, 0.5, 1.0, 2.0, 5.0}) {
                    const double exact =
                        limit({mass_kg, b, 0.0}, no_hand, {period_s, delay * period_s});
                    const double excess =
                        exact / linear_stiffness(b, 0.0, period_s, delay * period_s) - 1.0;
                    EXPECT_GE(excess, 0.0);
                    const bool is_mild = b * period_s / mass_kg <= 0.02 && delay <= 2.0;
                    EXPECT_LE(excess, is_mild ? 0.0087 : 0.148);
                }
            }
        }
    }
}

TEST(EigenvalueLimits, TooMuchVirtualDampingIsAnInstabilityOfItsOwn) {
    struct Row {
        double period_s, delay;
        double limits[7];  // at B = 0, 0.5, 1, 2, 5, 10, 20
    };

    constexpr double dampings[] = {0.0, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0};
    const Row rows[] = {
        {1e-3, 0.0, {200, 1188, 2157, 4037, 9233, 16536, 26821}},
        {1e-3, 1.0, {66.7, 396, 717, 1338, 3022, 5218, 7249}},
        {2e-3, 0.0, {100, 589, 1058, 1940, 4177, 6744, 8639}},
        {2e-3, 1.0, {33.4, 196, 351, 638, 1319, 1825, 279}},
    };
    for (const Row& row : rows) {
        for (int i = 0; i < 7; ++i) {
            const double found = limit({0.05, 0.1, 0.0}, no_hand,
                                       {row.period_s, row.delay * row.period_s, dampings[i]});
            EXPECT_NEAR(found, row.limits[i], 0.005 * row.limits[i]) << dampings[i];
        }
    }
    EXPECT_EQ(limit({0.05, 0.1, 0.0}, no_hand, {2e-3, 2e-3, 30.0}), 0.0);
}

TEST(EigenvalueLimits, ARigidHandAddsItsDamping) {
    struct Row {
        HandModel hand;
        double at_once, a_period_late;
    };

    const Row rows[] = {{no_hand, 200, 66.7},
                        {light_hand, 2205, 736},
                        {normal_hand, 6222, 2080},
                        {relaxed_arm, 13124, 4380}};
    for (const Row& row : rows) {
        EXPECT_NEAR(limit({}, row.hand, {1e-3, 0.0}), row.at_once, 0.005 * row.at_once);
        EXPECT_NEAR(limit({}, row.hand, {1e-3, 1e-3}), row.a_period_late,
                    0.005 * row.a_period_late);
    }
}

TEST(EigenvalueLimits, ABadlyDampedSkinIsTheWorstPartner) {
    struct Row {
        HandModel hand;
        double period_s, delay;
        double limits[2];  // at B = 0, 2
    };

    const Row rows[] = {
        {light_skin, 1e-3, 0.0, {3580, 6578}},     {light_skin, 1e-3, 1.0, {1885, 2619}},
        {normal_skin, 1e-3, 0.0, {7082, 10408}},   {normal_skin, 1e-3, 1.0, {2824, 3775}},
        {firm_skin, 1e-3, 0.0, {17210, 20377}},    {firm_skin, 1e-3, 1.0, {6174, 7110}},
        {light_skin, 2e-3, 0.0, {2353, 3499}},     {light_skin, 2e-3, 1.0, {1396, 1595}},
        {normal_bad_skin, 2e-3, 0.0, {925, 2319}}, {normal_bad_skin, 2e-3, 1.0, {444, 791}},
        {arm_bad_skin, 2e-3, 0.0, {714, 2317}},    {arm_bad_skin, 2e-3, 1.0, {264, 658}},
        {arm_fair_skin, 2e-3, 0.0, {2358, 3862}},  {arm_fair_skin, 2e-3, 1.0, {885, 1246}},
    };
    for (const Row& row : rows) {
        for (int i = 0; i < 2; ++i) {
            const double found =
                limit({}, row.hand, {row.period_s, row.delay * row.period_s, 2.0 * i});
            EXPECT_NEAR(found, row.limits[i], 0.005 * row.limits[i]);
        }
    }
}

TEST(EigenvalueLimits, TheDefaultsHaveTheirMargins) {
    struct Row {
        double period_s, delay, damping, stiffness;
        double worst;  // limit over three tips and eight hands
    };

    const Row rows[] = {
        {2e-3, 0.0, 1.5, 350, 1450},     {2e-3, 0.5, 1.5, 350, 722},
        {2e-3, 1.0, 1.5, 350, 452},      {1e-3, 0.0, 1.5, 700, 3046},
        {1e-3, 0.5, 1.5, 700, 1522},     {1e-3, 1.0, 1.5, 700, 1008},
        {2.5e-4, 0.0, 2.0, 1500, 16525}, {2.5e-4, 1.0, 2.0, 1500, 5498},
    };
    const HandModel hands[] = {no_hand,         light_skin,    light_bad_skin, normal_skin,
                               normal_bad_skin, arm_fair_skin, arm_bad_skin,   firm_skin};
    for (const Row& row : rows) {
        double worst = 1e9;
        for (const HandModel& hand : hands) {
            for (const double mass_kg : {0.03, 0.05, 0.08}) {
                worst =
                    std::min(worst, limit({mass_kg, 0.1, 0.0}, hand,
                                          {row.period_s, row.delay * row.period_s, row.damping}));
            }
        }
        EXPECT_NEAR(worst, row.worst, 0.05 * row.worst);
        EXPECT_GT(worst, row.stiffness);
    }
}

TEST(Passivity, TheGeneralConditionIsColgatesFormula) {
    struct Row {
        double stiffness, damping, period_s;
    };

    for (const Row& row : {Row{1000, 0, 1e-3}, Row{1000, 2, 1e-3}, Row{1000, -0.3, 1e-3},
                           Row{500, 0, 2e-3}, Row{500, 1, 2e-3}}) {
        const double expected = 0.5 * row.stiffness * row.period_s + std::abs(row.damping);
        const double least = least_damping_Ns_per_m(
            damped_spring(row.stiffness, row.damping, row.period_s), row.period_s);
        EXPECT_NEAR(least, expected, 1e-6 * expected);
        EXPECT_NEAR(colgate_stiffness(least, row.damping, row.period_s), row.stiffness, 1e-2);
    }
}

TEST(Passivity, DelayCostsKTimesDelayAndALittleMoreBetweenSamples) {
    const Transfer spring = damped_spring(1000.0, 0.0, 1e-3);
    EXPECT_NEAR(least_damping_Ns_per_m(spring, 1e-3, 1e-3), 1.5, 1e-5);
    EXPECT_NEAR(least_damping_Ns_per_m(spring, 1e-3, 2e-3), 2.5, 1e-5);
    EXPECT_NEAR(least_damping_Ns_per_m(spring, 1e-3, 0.5e-3), 0.5 * (1.0 + std::sqrt(1.25)), 1e-5);
}

TEST(Passivity, PassiveIsNeverStifferThanStable) {
    for (const double period_s : {2e-3, 1e-3, 2.5e-4}) {
        for (const double delay : {0.0, 0.5, 1.0, 2.0}) {
            for (const double damping : {0.0, 0.2, 0.5}) {
                for (const double cutoff_Hz : {30.0, 100.0, 1e9}) {
                    const SampledWall wall{period_s, delay * period_s, damping, cutoff_Hz};
                    const double share = low_pass_share(cutoff_Hz, period_s);
                    const auto make = [&](double stiffness) {
                        return damped_spring(stiffness, damping, period_s, share);
                    };
                    const double passive = passive_stiffness(make, 1.1, period_s, wall.delay_s);
                    EXPECT_LE(passive, limit({0.08, 1.1, 0.0}, no_hand, wall) + 1e-6);
                    EXPECT_GT(passive, 0.0);
                }
            }
        }
    }
}

}  // namespace
}  // namespace touchline::stability
