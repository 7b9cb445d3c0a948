// The least move is allowed, and no allowed move ends nearer.

#include "haptics/probe/probe_proxy.h"
#include "tests/haptics/collision/trials.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

Coupled random_vector(trials::Random& random) {
    return {random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5};
}

TEST(LeastMove, WithoutContactIsTheMoveWanted) {
    const LeastMove least = least_move({}, {1e-3, 2e-3, -3e-3});
    EXPECT_EQ(least.move, (Coupled{1e-3, 2e-3, -3e-3}));
    EXPECT_EQ(least.active_count, 0);
}

TEST(LeastMove, KeepsAllContactsAndNoAllowedMoveIsNearer) {
    trials::Random random(7);
    int held_by_three = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        std::vector<Constraint> constraints(1 + random.below(12));
        for (Constraint& c : constraints) c = {random_vector(random), 0.1 * random.unit()};
        const Coupled wanted = random_vector(random);
        const LeastMove least = least_move(constraints, wanted);
        for (const Constraint& c : constraints) {
            ASSERT_GE(dot3(c.row, least.move) + c.gap_m, -1e-9) << trial;
        }
        held_by_three += least.active_count == 3 ? 1 : 0;
        for (int i = 0; i < 200; ++i) {  // nearer places: are they allowed?
            Coupled other = least.move;
            const double size = random.decade(-6.0, 0.0);
            const Coupled by = random_vector(random);
            for (std::size_t axis = 0; axis < 3; ++axis) other[axis] += size * by[axis];
            if (left_of_move(wanted, other) >= left_of_move(wanted, least.move) - 1e-9) continue;
            bool is_allowed = true;
            for (const Constraint& c : constraints) {
                if (dot3(c.row, other) + c.gap_m < -1e-12) is_allowed = false;
            }
            ASSERT_FALSE(is_allowed) << trial;
        }
    }
    EXPECT_GT(held_by_three, 20);
}

TEST(LeastMove, TriedFirstWithWhatHeldAnotherIsTheSame) {
    trials::Random random(8);
    for (int trial = 0; trial < 2000; ++trial) {
        std::vector<Constraint> constraints(1 + random.below(12));
        for (Constraint& c : constraints) c = {random_vector(random), 0.1 * random.unit()};
        const Coupled wanted = random_vector(random);
        Coupled near = wanted;
        for (double& part : near) part += 0.1 * (random.unit() - 0.5);
        const LeastMove plain = least_move(constraints, wanted);
        const LeastMove tried = least_move(constraints, wanted, least_move(constraints, near));
        ASSERT_LT(left_of_move(plain.move, tried.move), 1e-12) << trial;
    }
}

}  // namespace
}  // namespace touchline
