#include "app/session/status.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

namespace touchline {
namespace {

Session shown_session() {
    const Session started = start_session(3).session;
    return picture_ready(started, started.request, {"Fish", 4, 6, ""}).session;
}

std::string value_of(const Status& status, const std::string& name) {
    const auto line = std::find_if(status.lines.begin(), status.lines.end(),
                                   [&](const StatusLine& l) { return l.name == name; });
    return line == status.lines.end() ? "" : line->value;
}

TEST(Status, SaysContactLevelForceAndMode) {
    HandState hand;
    hand.state = ContactState::vertex;
    hand.level = 2.46;
    hand.force = {0.6, -0.8};
    const Status status = describe(shown_session(), hand, "mouse");
    EXPECT_EQ(status.title, "Fish");
    EXPECT_EQ(value_of(status, "Contact"), "in a vertex");
    EXPECT_EQ(value_of(status, "Level"), "2.5, by speed");
    EXPECT_EQ(value_of(status, "Force"), "1.0 N");
    EXPECT_EQ(value_of(status, "Mode"), "wall");
    EXPECT_EQ(value_of(status, "Stiffness"), "medium, 500 N/m");
    EXPECT_EQ(value_of(status, "Detail"), "3 of 5, parts");
    EXPECT_EQ(value_of(status, "Picture"), "1 of 3");
    EXPECT_EQ(value_of(status, "Hand"), "mouse");
}

TEST(Status, NumbersThatLookTheSameGiveTheSameStatus) {
    HandState a, b;
    a.level = 1.01;
    b.level = 1.02;
    EXPECT_EQ(describe(shown_session(), a, "mouse"), describe(shown_session(), b, "mouse"));
}

TEST(Status, AStiffnessOnItsWayIsSaidAsItIsFelt) {
    HandState hand;
    hand.stiffness_N_per_m = 420.0;
    EXPECT_EQ(value_of(describe(shown_session(), hand, "mouse"), "Stiffness"), "medium, 420 N/m");
}

TEST(Status, NothingIsLeftUnnamedBeforeTheFirstPicture) {
    const Status status = describe(start_session(0).session, {}, "mouse");
    EXPECT_EQ(status.title, "No picture yet");
    EXPECT_EQ(value_of(status, "Picture"), "none in the list");
    for (const StatusLine& line : status.lines) EXPECT_FALSE(line.value.empty()) << line.name;
}

TEST(Status, SaysThatAPictureIsBeingOpenedAndWhyOneWasNot) {
    const Session loading = start_session(3).session;
    EXPECT_EQ(describe(loading, {}, "mouse").message, "Opening picture 1 ...");
    const Session failed = picture_failed(loading, loading.request, "why").session;
    EXPECT_EQ(describe(failed, {}, "mouse").message, "why");
}

TEST(Status, TheReadmeHoldsTheKeyTableAsItIs) {
    std::ifstream file(TOUCHLINE_SOURCE_DIR "/app/session/README.md");
    std::stringstream text;
    text << file.rdbuf();
    EXPECT_NE(text.str().find(keys_as_markdown()), std::string::npos)
        << "app/session/README.md must hold exactly:\n"
        << keys_as_markdown();
}

}  // namespace
}  // namespace touchline
