// Whatever doubles come in, what comes out is finite, within every limit, and zero in doubt.

#include "tests/haptics/safety/chains.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

// Special values, any bit pattern, and the ordinary range, in equal parts.
double any_double() {
    using limits = std::numeric_limits<double>;
    static constexpr double special[] = {0.0,
                                         -0.0,
                                         limits::quiet_NaN(),
                                         limits::infinity(),
                                         -limits::infinity(),
                                         limits::denorm_min(),
                                         1e308,
                                         -1e308,
                                         limits::max(),
                                         limits::min(),
                                         1e-300};
    switch (*rc::gen::inRange(0, 3)) {
        case 0:
            return special[*rc::gen::inRange(0, 11)];
        case 1:
            return std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>());
        default:
            return *rc::gen::inRange(-100000, 100001) / 10000.0;
    }
}

// Mostly like a device, now and then anything.
Jacobian any_jacobian() {
    if (*rc::gen::inRange(0, 4) == 0) {
        return {{any_double(), any_double()}, {any_double(), any_double()}};
    }
    const auto entry = [] { return *rc::gen::inRange(-1000, 1001) / 10000.0; };
    return {{entry(), entry()}, {entry(), entry()}};
}

/// Each input is now and then anything, and otherwise what a device and a hand give.
ChainInput any_input() {
    const auto is_odd = [] { return *rc::gen::inRange(0, 15) == 0; };
    const auto ordinary = [](double most) { return most * *rc::gen::inRange(-1000, 1001) / 1000; };
    ChainInput input;
    input.wanted_D = is_odd() ? Force{any_double(), any_double()} : Force{ordinary(5), ordinary(5)};
    input.is_placed = !is_odd();
    if (!is_odd()) input.jacobian = any_jacobian();
    if (is_odd()) input.p_D = {any_double(), any_double()};
    input.velocity_D =
        is_odd() ? Velocity{any_double(), any_double()} : Velocity{ordinary(1.2), ordinary(1.2)};
    input.is_wanted = !is_odd();
    input.is_fading = is_odd();
    input.is_stopped = is_odd() && is_odd();
    input.is_lost = is_odd() && is_odd();
    return input;
}

bool is_zero(const SafeForce& out) {
    return out.force_D == Force{} && out.torques == JointTorques{} && out.plane_share == 0.0;
}

/// Steps a live chain through hostile inputs.
void stay_within(const ForceLimits& limits) {
    ForceChain chain = live_chain(limits);
    Force last;
    for (int tick = 0; tick < 20; ++tick) {
        const double dt_s = *rc::gen::inRange(0, 10) == 0 ? any_double() : tick_s;
        const ChainInput input = any_input();
        const SafeForce out = chain.step(input, dt_s);

        RC_ASSERT(is_finite(out.force_D) && is_finite(out.torques));
        RC_ASSERT(norm(out.force_D) <= limits.force_N * (1.0 + 1e-12));
        RC_ASSERT(std::abs(out.torques.x) <= limits.torque_Nm * (1.0 + 1e-12));
        RC_ASSERT(std::abs(out.torques.y) <= limits.torque_Nm * (1.0 + 1e-12));
        const double growth = norm(out.force_D) - norm(last);
        RC_ASSERT(growth <= 0.0 || growth <= limits.rise_N_per_s * dt_s + 1e-12);
        const bool is_fast = is_finite(input.velocity_D) && norm(input.velocity_D) > 1.0;
        RC_ASSERT(!is_fast || dot(out.force_D, input.velocity_D) <= 0.0);
        const bool is_known = input.is_placed && (limits.continuous_N || input.jacobian);
        if (!is_known || !is_finite(input.wanted_D) || !std::isfinite(dt_s))
            RC_ASSERT(is_zero(out));
        if (limits.continuous_N) RC_ASSERT(out.torques == JointTorques{});
        RC_ASSERT(out.plane_share >= 0.0 && out.plane_share <= 1.0);
        if (chain.state() == ForceState::fault) RC_ASSERT(is_zero(out));
        last = out.force_D;
        // Faults end, so that there is force to limit.
        if (chain.state() == ForceState::fault && *rc::gen::inRange(0, 2) == 0) {
            chain = live_chain(limits);
            last = {};
        }
    }
}

RC_GTEST_PROP(ForceChainProperties, AnyDoublesGiveFiniteForcesWithinEveryLimit, ()) {
    stay_within({});
}

RC_GTEST_PROP(ForceChainProperties, SoTheyDoWithADeviceThatTakesForces, ()) {
    stay_within(of_forces());
}

RC_GTEST_PROP(ForceChainProperties, ScalingKeepsTheDirectionAndTorquesAreThoseOfTheForce, ()) {
    ForceChain chain = live_chain();
    const Force wanted{*rc::gen::inRange(-9000, 9001) / 1000.0,
                       *rc::gen::inRange(-9000, 9001) / 1000.0};
    const auto entry = [] { return *rc::gen::inRange(200, 800) / 10000.0; };
    const Jacobian pose{{-entry(), -entry()}, {-entry(), entry()}};
    SafeForce out;
    for (int i = 0; i < 50; ++i) out = chain.step(wanting(wanted, pose), tick_s);
    RC_ASSERT(std::abs(cross(out.force_D, wanted)) <= 1e-12 * (1.0 + norm(wanted)));
    RC_ASSERT(dot(out.force_D, wanted) >= 0.0);
    const JointTorques torques = joint_torques(pose, out.force_D);
    RC_ASSERT(norm(torques - out.torques) <= 1e-15);
}

RC_GTEST_PROP(ForceChainProperties, ForceChangesByAtMostTheSlew, ()) {
    const ForceLimits limits;
    ForceChain chain = live_chain();
    Force last;
    for (int tick = 0; tick < 30; ++tick) {
        const Force wanted{*rc::gen::inRange(-3000, 3001) / 1000.0,
                           *rc::gen::inRange(-3000, 3001) / 1000.0};
        const SafeForce out = chain.step(wanting(wanted), tick_s);
        if (out.limit != Limit::torque) {
            RC_ASSERT(norm(out.force_D - last) <= limits.change_N_per_s * tick_s + 1e-12);
        }
        last = out.force_D;
    }
}

}  // namespace
}  // namespace touchline
