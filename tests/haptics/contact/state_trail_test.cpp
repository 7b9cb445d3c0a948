#include "haptics/contact/proxy_state.h"

#include <string>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using enum ContactState;

std::string text(const StateTrail& trail) {
    std::string states;
    for (int i = 0; i < trail.size(); ++i) {
        states += static_cast<char>('0' + static_cast<int>(trail[i]));
    }
    return states;
}

TEST(StateTrail, KeepsTheOrderAndLeavesOutRepeats) {
    StateTrail trail(free);
    EXPECT_EQ(text(trail), "0");
    for (const ContactState state : {free, edge, edge, vertex, vertex}) trail.add(state);
    EXPECT_EQ(text(trail), "012");
}

TEST(StateTrail, CountsAWalkOverAVertexAsOneEdge) {
    StateTrail trail(free);
    for (const ContactState state : {edge, vertex, edge, vertex, edge, free}) trail.add(state);
    EXPECT_EQ(text(trail), "010");
    StateTrail rests(vertex);
    for (const ContactState state : {edge, vertex}) rests.add(state);
    EXPECT_EQ(text(rests), "212");
}

TEST(StateTrail, HoldsSixteenStatesAndLeavesOutFurtherOnes) {
    StateTrail trail(free);
    for (int i = 0; i < 20; ++i) {
        trail.add(edge);
        trail.add(free);
    }
    EXPECT_EQ(text(trail), "0101010101010101");
}

}  // namespace
}  // namespace touchline
