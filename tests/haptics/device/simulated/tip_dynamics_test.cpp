#include "haptics/device/simulated/simulated_pantograph.h"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

constexpr double substep_s = 1.25e-4;

void run(TipDynamics& dynamics, Force force, const Intention& intention, double span_s) {
    const int steps = static_cast<int>(std::lround(span_s / substep_s));
    for (int i = 0; i < steps; ++i) dynamics.step(force, intention, substep_s);
}

TEST(TipDynamics, VelocityDecaysExponentially) {
    TipDynamics dynamics({0.05, 0.5, 0.0}, no_hand, {});
    dynamics.set_velocity({0.2, -0.1});
    run(dynamics, {}, {}, 0.1);
    const double decay = std::exp(-0.5 / 0.05 * 0.1);
    EXPECT_NEAR(dynamics.tip().velocity.x, 0.2 * decay, 1e-3 * 0.2 * decay);
    EXPECT_NEAR(dynamics.tip().position.x, 0.2 * 0.05 / 0.5 * (1.0 - decay), 1e-3 * 0.02);
    EXPECT_NEAR(dynamics.tip().position.y, -0.5 * dynamics.tip().position.x, 1e-15);
}

TEST(TipDynamics, FrictionStopsItWhereTheEnergyIsSpent) {
    TipDynamics dynamics({0.05, 0.0, 0.1}, no_hand, {});
    dynamics.set_velocity({0.12, 0.16});
    run(dynamics, {}, {}, 0.2);
    EXPECT_EQ(dynamics.tip().velocity, Velocity{});
    EXPECT_NEAR(norm(dynamics.tip().position), 0.05 * 0.04 / (2.0 * 0.1), 1e-6);
}

TEST(TipDynamics, FrictionHoldsExactlyBelowItsLimit) {
    TipDynamics dynamics({0.05, 0.1, 0.1}, no_hand, {0.01, 0.02});
    run(dynamics, {0.07, 0.07}, {}, 1.0);
    EXPECT_EQ(dynamics.tip().position, (Position{0.01, 0.02}));
    run(dynamics, {0.08, 0.08}, {}, 0.01);
    EXPECT_GT(dynamics.tip().velocity.x, 0.0);
}

TEST(TipDynamics, ConstantForceReachesItsTerminalVelocity) {
    TipDynamics dynamics({0.05, 0.4, 0.05}, no_hand, {});
    run(dynamics, {0.25, 0.0}, {}, 2.0);
    EXPECT_NEAR(dynamics.tip().velocity.x, 0.2 / 0.4, 5e-4);
}

TEST(TipDynamics, RigidHandSettlesWhereItsSpringBalancesTheForce) {
    TipDynamics dynamics({0.05, 0.1, 0.0}, normal_hand, {});
    run(dynamics, {0.6, 0.0}, {{0.01, 0.0}, {}}, 3.0);
    EXPECT_NEAR(dynamics.tip().position.x, 0.01 + 0.6 / 300.0, 1e-9);
    EXPECT_EQ(dynamics.hand().position, dynamics.tip().position);
}

TEST(TipDynamics, SkinTakesItsShareOfTheStretch) {
    HandModel hand = normal_hand;
    hand.skin = HandModel::Skin{1000.0, 3.0};
    TipDynamics dynamics({0.05, 0.1, 0.0}, hand, {});
    run(dynamics, {0.6, 0.0}, {{0.01, 0.0}, {}}, 5.0);
    EXPECT_NEAR(dynamics.hand().position.x, 0.01 + 0.6 / 300.0, 1e-7);
    EXPECT_NEAR(dynamics.tip().position.x - dynamics.hand().position.x, 0.6 / 1000.0, 1e-7);
}

TEST(TipDynamics, StopsWhereItIsTold) {
    TipDynamics dynamics({0.05, 0.1, 0.0}, no_hand, {});
    dynamics.set_velocity({1.0, 0.0});
    dynamics.stop_at({0.003, 0.0});
    EXPECT_EQ(dynamics.tip().position, (Position{0.003, 0.0}));
    EXPECT_EQ(dynamics.tip().velocity, Velocity{});
}

double energy_J(const TipDynamics& d, const TipParameters& tip, const HandModel& hand,
                Position intended) {
    const auto kinetic = [](double m, Velocity v) { return 0.5 * m * dot(v, v); };
    const auto spring = [](double k, Position x) { return 0.5 * k * dot(x, x); };
    if (!hand.skin) {
        return kinetic(tip.mass_kg + hand.mass_kg, d.tip().velocity) +
               spring(hand.stiffness_N_per_m, d.tip().position - intended);
    }
    return kinetic(tip.mass_kg, d.tip().velocity) + kinetic(hand.mass_kg, d.hand().velocity) +
           spring(hand.stiffness_N_per_m, d.hand().position - intended) +
           spring(hand.skin->stiffness_N_per_m, d.tip().position - d.hand().position);
}

RC_GTEST_PROP(TipDynamics, EnergyIsNeverCreatedWithoutForce, ()) {
    HandModel hand = *rc::gen::element(no_hand, light_hand, normal_hand, relaxed_arm, stiff_arm);
    if (hand.mass_kg > 0.0 && *rc::gen::arbitrary<bool>()) hand.skin = HandModel::Skin{1000.0, 3.0};
    const TipParameters tip{*rc::gen::inRange(30, 100) * 1e-3, *rc::gen::inRange(0, 100) * 1e-2,
                            *rc::gen::inRange(0, 20) * 1e-2};
    TipDynamics dynamics(tip, hand, {});
    dynamics.set_velocity(
        {*rc::gen::inRange(-500, 501) * 1e-3, *rc::gen::inRange(-500, 501) * 1e-3});
    const Intention still{{*rc::gen::inRange(-20, 21) * 1e-3, 0.0}, {}};
    const double at_start = energy_J(dynamics, tip, hand, still.position);
    double least = at_start;
    for (int i = 0; i < 8000; ++i) {
        dynamics.step({}, still, substep_s);
        const double now = energy_J(dynamics, tip, hand, still.position);
        // The springs are explicit, so within an oscillation energy wavers by order h.
        RC_ASSERT(now <= least + 0.02 * at_start + 1e-15);
        least = std::min(least, now);
    }
    if (tip.viscous_Ns_per_m > 0.3) RC_ASSERT(least < 0.5 * at_start + 1e-15);
}

}  // namespace
}  // namespace touchline
