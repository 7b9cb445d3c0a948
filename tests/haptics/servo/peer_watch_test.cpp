#include "haptics/servo/exchange.h"
#include "tests/haptics/tick.h"

#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

namespace touchline {
namespace {

PeerWatch watch_of_10_ms() {
    return {0.010, 0.002};
}

TEST(PeerWatch, IsLostUntilTheFirstBeat) {
    PeerWatch watch = watch_of_10_ms();
    EXPECT_TRUE(watch.step(0, tick_s));
    EXPECT_TRUE(watch.step(0, tick_s));
    EXPECT_FALSE(watch.step(1, tick_s));
}

TEST(PeerWatch, IsLostAfterTheSilenceAndBackWithABeat) {
    PeerWatch watch = watch_of_10_ms();
    for (std::uint64_t beat = 1; beat < 5; ++beat) {
        EXPECT_FALSE(watch.step(beat, tick_s));
        for (int k = 0; k < 9; ++k) EXPECT_FALSE(watch.step(beat, tick_s)) << k;
    }
    EXPECT_TRUE(watch.step(4, tick_s * 1.001));
    EXPECT_TRUE(watch.step(4, tick_s));
    EXPECT_FALSE(watch.step(5, tick_s));
}

TEST(PeerWatch, AStandstillOfTheMachineIsNoSilence) {
    PeerWatch watch = watch_of_10_ms();
    EXPECT_FALSE(watch.step(1, tick_s));
    EXPECT_FALSE(watch.step(1, 3.0));
    EXPECT_FALSE(watch.step(1, 3.0));
    EXPECT_FALSE(watch.step(1, std::numeric_limits<double>::quiet_NaN()));
    for (int k = 0; k < 4; ++k) (void)watch.step(1, tick_s);
    EXPECT_TRUE(watch.step(1, tick_s));
}

TEST(PeerWatch, TimeThatGoesBackDoesNotForgiveSilence) {
    PeerWatch watch = watch_of_10_ms();
    (void)watch.step(1, tick_s);
    bool is_lost = false;
    for (int k = 0; k < 11; ++k) {
        (void)watch.step(1, -1.0);
        is_lost = watch.step(1, tick_s);
    }
    EXPECT_TRUE(is_lost);
}

TEST(ForceShare, FallsToZeroWithinTheFadeAndEndsAFadeThatHasBegun) {
    ForceShare share;
    EXPECT_EQ(share.step(false, tick_s), 1.0);
    double last = share.step(true, tick_s);
    EXPECT_LT(last, 1.0);
    for (int k = 0; k < 7; ++k) {
        const double now = share.step(false, tick_s);  // no longer wanted off, but has begun
        EXPECT_LT(now, last);
        last = now;
    }
    EXPECT_EQ(last, 0.0);
    EXPECT_EQ(share.step(true, tick_s), 0.0);
    EXPECT_EQ(share.step(false, tick_s), 1.0);
}

TEST(ForceShare, ATimeThatIsNoneEndsIt) {
    for (const double dt_s : {std::numeric_limits<double>::quiet_NaN(), 0.0, -1.0}) {
        ForceShare share;
        EXPECT_EQ(share.step(true, dt_s), 0.0);
    }
}

}  // namespace
}  // namespace touchline
