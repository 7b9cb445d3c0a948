#include "haptics/servo/recorder.h"

#include <gtest/gtest.h>

namespace touchline {
namespace {

HandState at(double time_s) {
    HandState hand;
    hand.time_s = time_s;
    hand.p_WH = {time_s, 1.0};
    hand.p_WP = {time_s, 2.0};
    hand.force = {0.5, time_s};
    hand.level = 1.5;
    hand.state = ContactState::vertex;
    return hand;
}

TEST(Recorder, KeepsWhatATickWas) {
    Recorder recorder(4);
    recorder.push(at(3.0));
    const auto ticks = recorder.ticks();
    ASSERT_EQ(ticks.size(), 1U);
    EXPECT_EQ(ticks[0].time_s, 3.0);
    EXPECT_EQ(ticks[0].p_WH, (Position{3.0, 1.0}));
    EXPECT_EQ(ticks[0].p_WP, (Position{3.0, 2.0}));
    EXPECT_EQ(ticks[0].force, (Force{0.5, 3.0}));
    EXPECT_EQ(ticks[0].level, 1.5);
    EXPECT_EQ(ticks[0].state, ContactState::vertex);
}

TEST(Recorder, KeepsTheNewestOldestFirst) {
    Recorder recorder(3);
    for (int i = 0; i < 8; ++i) recorder.push(at(i));
    const auto ticks = recorder.ticks();
    ASSERT_EQ(ticks.size(), 3U);
    EXPECT_EQ(ticks[0].time_s, 5.0);
    EXPECT_EQ(ticks[2].time_s, 7.0);
}

TEST(Recorder, WithoutRoomKeepsNothing) {
    Recorder recorder;
    recorder.push(at(1.0));
    EXPECT_TRUE(recorder.ticks().empty());
}

}  // namespace
}  // namespace touchline
