// What a moving wall may do to the hand, and how a gap in the force closes.
#include "haptics/contact/contact_machine.h"
#include "haptics/contact/proxy_state.h"
#include "tests/haptics/tick.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double trickle_J = 1e-7;  // in a tick
constexpr double tiny_J = 1e-15;

TEST(EnergyAccount, EarnsWhatWasDissipatedAndATrickle) {
    EnergyAccount account;
    EXPECT_EQ(account.balance_J(), 0.0);
    account.earn(0.0, tick_s);
    EXPECT_NEAR(account.balance_J(), trickle_J, tiny_J);
    EnergyAccount other;
    other.earn(1e-4, tick_s);
    EXPECT_NEAR(other.balance_J(), 1e-4 + trickle_J, tiny_J);
    EnergyAccount none;
    none.earn(-1e-4, tick_s);  // given to the hand: neither debt nor credit
    EXPECT_NEAR(none.balance_J(), trickle_J, tiny_J);
}

TEST(EnergyAccount, ForgetsInASecondAndIsNeverInDebt) {
    EnergyAccount account;
    account.earn(1e-3, tick_s);
    for (int i = 0; i < 1000; ++i) account.earn(0.0, tick_s);
    EXPECT_NEAR(account.balance_J(), std::exp(-1.0) * 1e-3 + (1.0 - std::exp(-1.0)) * 1e-4, 1e-6);
    account.earn(0.0, 5.0);
    EXPECT_NEAR(account.balance_J(), 5e-4, 1e-12);  // the trickle of those five seconds
}

TEST(EnergyAccount, HoldsTwoMillijoulesAtMost) {
    EnergyAccount account;
    account.earn(1.0, tick_s);
    EXPECT_EQ(account.balance_J(), 2e-3);
    EXPECT_TRUE(account.spend(-1.0));
    EXPECT_EQ(account.balance_J(), 2e-3);
}

TEST(EnergyAccount, SpendsWhatItHasAndNothingOfWhatItHasNot) {
    EnergyAccount account;
    account.earn(1.0, tick_s);
    EXPECT_FALSE(account.spend(2.1e-3));
    EXPECT_FALSE(account.spend(std::numeric_limits<double>::quiet_NaN()));
    EXPECT_EQ(account.balance_J(), 2e-3);
    EXPECT_TRUE(account.spend(1.5e-3));
    EXPECT_NEAR(account.balance_J(), 5e-4, tiny_J);
    EXPECT_TRUE(account.spend(-3e-4));  // a wall that gives way
    EXPECT_NEAR(account.balance_J(), 8e-4, tiny_J);
    EXPECT_TRUE(account.spend(account.balance_J()));
    EXPECT_EQ(account.balance_J(), 0.0);
}

/// Closes by 0.02 N a tick along the gap until nothing is left.
TEST(GapFade, ClosesByTwentyNewtonsASecond) {
    GapFade gap;
    EXPECT_FALSE(gap.is_open());
    gap.start({0.06, 0.08}, {0.06, 0.13});
    EXPECT_EQ(gap.step(tick_s), (Force{0.0, 0.08 - 0.13}));
    EXPECT_NEAR(gap.step(tick_s).y, -0.03, 1e-12);
    EXPECT_NEAR(gap.step(tick_s).y, -0.01, 1e-12);
    EXPECT_FALSE(gap.is_open());
    EXPECT_EQ(gap.step(tick_s), Force{});
}

TEST(GapFade, OfNoNumberThereIsNone) {
    GapFade gap;
    gap.start({std::numeric_limits<double>::infinity(), 0.0}, {1.0, 0.0});
    EXPECT_FALSE(gap.is_open());
}

}  // namespace
}  // namespace touchline
