// A force chain at work, for the tests that start from one.
#pragma once

#include "haptics/safety/force_chain.h"
#include "tests/haptics/tick.h"

#include <limits>

#include <gtest/gtest.h>

namespace touchline {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
// A pose of a 2diy gen 3: condition about 1.
inline constexpr Jacobian good_pose{{-0.049, -0.0496}, {-0.049, 0.0496}};

inline Jacobian pose_with_condition(double c) {
    return {{0.02 * c, 0.0}, {0.0, 0.02}};
}

inline ChainInput wanting(Force wanted, const Jacobian& pose = good_pose) {
    ChainInput input;
    input.wanted_D = wanted;
    input.is_placed = true;
    input.jacobian = pose;
    return input;
}

/// The limits of a device without joints.
inline ForceLimits of_forces() {
    ForceLimits limits;
    limits.continuous_N = 1.8;
    return limits;
}

inline ForceChain live_chain(const ForceLimits& limits = {}) {
    ForceChain chain(limits);
    for (int i = 0; i < 1000; ++i) (void)chain.step(wanting({}), tick_s);
    EXPECT_EQ(chain.state(), ForceState::live);
    return chain;
}

inline SafeForce run(ForceChain& chain, const ChainInput& input, int ticks = 100) {
    SafeForce last;
    for (int i = 0; i < ticks; ++i) last = chain.step(input, tick_s);
    return last;
}

inline SafeForce settled(ForceChain& chain, Force wanted, const Jacobian& pose = good_pose) {
    return run(chain, wanting(wanted, pose));
}

}  // namespace touchline
