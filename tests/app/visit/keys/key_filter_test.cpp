// Tests which presses count (accessibility IN-4).
#include "app/visit/keys/key_filter.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

constexpr PhysicalKey a{KeySource::key, 'A'};
constexpr PhysicalKey b{KeySource::joystick, 0};

KeyChange down(const PhysicalKey& key, double time_s) {
    return {key, true, false, time_s};
}

KeyChange up(const PhysicalKey& key, double time_s) {
    return {key, false, false, time_s};
}

TEST(KeyFilter, IN4_AHeldKeyCountsOnce) {
    KeyFilter filter(0.0);
    EXPECT_TRUE(filter.takes(down(a, 0.0)));
    for (int i = 1; i < 100; ++i) {
        EXPECT_FALSE(filter.takes({a, true, true, 0.03 * i})) << "the window system's repeat";
        EXPECT_FALSE(filter.takes(down(a, 0.03 * i))) << "a repeat that does not say so";
    }
    EXPECT_FALSE(filter.takes(up(a, 4.0))) << "the press acts, not the release";
    EXPECT_TRUE(filter.takes(down(a, 4.1)));
}

TEST(KeyFilter, IN4_ASecondStrikeIsLeftOutAsLongAsItIsSet) {
    for (const double double_strike_s : {0.1, 0.3, 0.5, 7.0}) {
        const double border_s = std::min(double_strike_s, 0.5);
        KeyFilter filter(double_strike_s);
        EXPECT_TRUE(filter.takes(down(a, 1.0)));
        (void)filter.takes(up(a, 1.01));
        EXPECT_FALSE(filter.takes(down(a, 1.0 + 0.9 * border_s)));
        (void)filter.takes(up(a, 1.0 + 0.95 * border_s));
        EXPECT_TRUE(filter.takes(down(a, 1.0 + 1.01 * border_s)));
    }
}

TEST(KeyFilter, AnotherKeyIsNoSecondStrike) {
    KeyFilter filter(0.5);
    EXPECT_TRUE(filter.takes(down(a, 1.0)));
    EXPECT_TRUE(filter.takes(down(b, 1.001)));
}

/// A hand that trembles faster than the filter is still heard twice a second.
TEST(KeyFilter, TremblingIsHeard) {
    KeyFilter filter(0.5);
    int counted = 0;
    for (int i = 0; i < 100; ++i) {
        counted += filter.takes(down(a, 0.1 * i)) ? 1 : 0;
        (void)filter.takes(up(a, 0.1 * i + 0.05));
    }
    EXPECT_GE(counted, 16);
    EXPECT_LE(counted, 20);
}

/// Two counted presses of a key are never closer than the filter says, and there is a release
/// between them.
RC_GTEST_PROP(KeyFilter, NeverCountsTwiceWithinTheFilter, ()) {
    const double double_strike_s = *rc::gen::inRange(0, 51) / 100.0;
    KeyFilter filter(double_strike_s);
    double time_s = 0.0;
    double last_s = -10.0;
    bool is_released = true;
    for (int i = 0; i < 200; ++i) {
        time_s += *rc::gen::inRange(0, 300) / 1000.0;
        const bool is_down = *rc::gen::arbitrary<bool>();
        const bool is_repeat = *rc::gen::inRange(0, 5) == 0;
        const bool counts = filter.takes({a, is_down, is_repeat, time_s});
        if (counts) {
            RC_ASSERT(is_down && !is_repeat && is_released);
            RC_ASSERT(time_s - last_s >= double_strike_s);
            last_s = time_s;
            is_released = false;
        }
        if (!is_down) is_released = true;
    }
}

}  // namespace
}  // namespace touchline
