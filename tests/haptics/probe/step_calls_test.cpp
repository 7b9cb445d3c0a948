// A step allocates nothing and takes no lock.

#include "tests/haptics/call_counts.h"
#include "tests/haptics/probe/hands.h"
#include "tests/haptics/scenes.h"

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(ProbeStep, AllocatesAndLocksNothing) {
    const Scene scene = trials::scene_of(scenes::random_map(3, 5), 3);
    for (std::size_t number = 0; number < 6; ++number) {
        const ProbeShape shape = any_shape(number);
        RestlessHand hand(number);
        ProbeProxy proxy;
        proxy.reset(shape, scene, hand.step(), 0.0);
        const CallCounter counter;
        (void)take_call_counts();
        int in_contact = 0;
        for (int k = 0; k < 5000; ++k) {
            const double level = 0.25 * ((k / 500) % 8);
            in_contact += proxy.step(hand.step(), level, {}, {}).contact_count > 0 ? 1 : 0;
        }
        const CallCounts counts = take_call_counts();
        EXPECT_EQ(counts.allocations, 0U);
        EXPECT_EQ(counts.locks, 0U);
        EXPECT_GT(in_contact, 500);
    }
}

}  // namespace
}  // namespace touchline
