// Faults while the board is being opened or stopped: it opens in the end, or says why not; the
// motors never pull meanwhile.
#include "tests/machines/sim/board/board_rig.h"

#include <random>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr JointTorques asked{0.02, -0.02};

bool is_unplugging(LinkFault fault) {
    return fault == LinkFault::unplugged_before || fault == LinkFault::unplugged_after;
}

TEST(OpenFaults, OneFaultAnywhereInOpeningIsOvercome) {
    for (int fault = 1; fault < link_faults; ++fault) {
        for (std::size_t at = 0; at < 4; ++at) {
            for (std::uint64_t seed = 0; seed < 10; ++seed) {
                const auto kind = static_cast<LinkFault>(fault);
                BoardRig rig({}, {{at, kind, 0.009, seed}});
                const bool is_open = rig.driver->open().has_value();
                SCOPED_TRACE(testing::Message() << fault << " at send " << at << " seed " << seed);
                ASSERT_EQ(is_open, !is_unplugging(kind) || at > 1);
                ASSERT_FALSE(rig.board.firmware().is_broken());
                ASSERT_EQ(rig.held(), JointTorques{});
                if (!is_open) continue;
                rig.tick_for(0.2, asked);
                if (is_unplugging(kind) || kind == LinkFault::lost_counts) continue;
                ASSERT_EQ(rig.driver->report().state, BoardState::ready);
                ASSERT_GT(norm(rig.held()), 0.02);
            }
        }
    }
}

TEST(OpenFaults, OneFaultAnywhereInStoppingStillEndsInZero) {
    for (int fault = 1; fault < link_faults; ++fault) {
        for (std::size_t after = 0; after < 3; ++after) {
            for (std::uint64_t seed = 0; seed < 10; ++seed) {
                const auto kind = static_cast<LinkFault>(fault);
                BoardRig rig({}, {{12 + after, kind, 0.009, seed}});
                ASSERT_TRUE(rig.driver->open().has_value());
                rig.tick_for(0.0095, asked);
                ASSERT_EQ(rig.link->commands().size(), 12U);
                const bool is_confirmed = rig.driver->stop();
                SCOPED_TRACE(testing::Message() << fault << " after " << after << " seed " << seed);
                ASSERT_EQ(rig.held(), JointTorques{});
                ASSERT_TRUE(is_confirmed || is_unplugging(kind));
                ASSERT_FALSE(rig.board.firmware().is_broken());
            }
        }
    }
}

// Any number of faults of any kind, in any order.
TEST(OpenFaults, ManyFaultsNeverLeaveTheMotorsPulling) {
    std::mt19937_64 random(11);
    for (int run = 0; run < 300; ++run) {
        std::vector<PlannedFault> faults;
        for (std::size_t at = 0; at < 400; ++at) {
            if (random() % 8 != 0) continue;
            const auto kind = static_cast<LinkFault>(random() % static_cast<unsigned>(link_faults));
            if (!is_unplugging(kind)) faults.push_back({at, kind, 0.009, random()});
        }
        BoardRig rig({}, faults);
        (void)rig.driver->open();
        rig.tick_for(0.3, asked);
        ASSERT_FALSE(rig.board.firmware().is_broken()) << run;
        rig.driver->stop();
        if (rig.driver->report().state == BoardState::closed) {
            ASSERT_EQ(rig.held(), JointTorques{}) << run;
        }
    }
}

}  // namespace
}  // namespace touchline
