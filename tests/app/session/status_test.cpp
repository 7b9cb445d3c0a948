#include "app/session/status.h"

#include "app/session/keys.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

namespace touchline {
namespace {

LiveFacts shown() {
    LiveFacts facts;
    facts.title = "Fish";
    facts.coarsest_level = 6;
    facts.hand_words = "mouse";
    return facts;
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
    const Status status = describe(shown(), hand, {});
    EXPECT_EQ(status.title, "Fish");
    EXPECT_EQ(value_of(status, "Contact"), "at a corner");
    EXPECT_EQ(value_of(status, "Level"), "2.5 of 6, by speed");
    EXPECT_EQ(value_of(status, "Force"), "1.0 N");
    EXPECT_EQ(value_of(status, "Kind of line"), "wall");
    EXPECT_EQ(value_of(status, "Detail"), "3 of 5, parts");
    EXPECT_EQ(value_of(status, "Hand"), "mouse");
}

TEST(Status, SaysWhichPageAndWhichPictureOfIt) {
    const auto page_of = [](const PagePlace& place) {
        LiveFacts facts = shown();
        facts.place = place;
        return value_of(describe(facts, {}, {}), "Page");
    };
    EXPECT_EQ(page_of({2, 7, 1, 4}), "2 of 7, picture 1 of 3");
    EXPECT_EQ(page_of({2, 7, 4, 4}), "2 of 7, the whole page");
    EXPECT_EQ(page_of({1, 1, 1, 2}), "1 of 1, picture 1 of 1");
    EXPECT_EQ(page_of({2, 7, 1, 1}), "2 of 7");
    EXPECT_EQ(page_of({1, 1, 1, 1}), "");
}

TEST(Status, SaysTheLastEventInWords) {
    const auto last_words = [](const std::optional<ContactEvent>& last) {
        LiveFacts facts = shown();
        facts.last = last;
        return value_of(describe(facts, {}, {}), "Last");
    };
    EXPECT_EQ(last_words({}), "nothing yet");
    ContactEvent event;
    event.kind = ContactEventKind::line_crossed;
    EXPECT_EQ(last_words(event), "crossed a line");
    std::set<std::string> words;
    for (int kind = 0; kind <= static_cast<int>(ContactEventKind::popped_through); ++kind) {
        event.kind = static_cast<ContactEventKind>(kind);
        words.insert(last_words(event));
    }
    EXPECT_EQ(words.size(), 10U);
    EXPECT_FALSE(words.contains(""));
}

TEST(Status, SaysThatAWallGivesWay) {
    LiveFacts facts = shown();
    facts.gives_way = true;
    HandState hand;
    hand.mode = Mode::groove;
    EXPECT_EQ(value_of(describe(facts, hand, {}), "Kind of line"), "groove");
    hand.mode = Mode::wall;
    EXPECT_EQ(value_of(describe(facts, hand, {}), "Kind of line"), "wall, gives way to a push");
}

std::string level_words(const LevelTerms& terms, bool is_automatic) {
    HandState hand;
    hand.level_terms = terms;
    hand.level = choose_level(terms).level;
    hand.is_level_auto = is_automatic;
    return value_of(describe(shown(), hand, {}), "Level");
}

TEST(Status, SaysWhichTermDecidesTheLevel) {
    EXPECT_EQ(level_words({.speed = 3.0}, true), "3 of 6, by speed");
    EXPECT_EQ(level_words({.percept = 2.0}, true), "2 of 6, finer feels the same");
    EXPECT_EQ(level_words({.finest = 2.0}, true), "2 of 6, the finest set");
    EXPECT_EQ(level_words({.speed = 3.0, .coarsest = 1.0}, true), "1 of 6, the coarsest set");
    EXPECT_EQ(level_words({.encoder = 1.0}, true), "1 of 6, the device tells no finer");
    EXPECT_EQ(level_words({.radius = 1.0}, true), "1 of 6, finer than the proxy");
    EXPECT_EQ(level_words({.cost = 4.0}, true), "4 of 6, finer takes too long");
    EXPECT_EQ(level_words({.speed = 9.0, .safe = 5.0}, true), "5 of 6, the coarsest safe");
}

TEST(Status, AFixedLevelIsSaidToBeFixedOrWhyItIsNotReached) {
    LevelTerms terms{.speed = 0.0, .finest = 2.0, .coarsest = 2.0};
    for (const double speed : {0.0, 2.0, 5.0}) {
        terms.speed = speed;
        EXPECT_EQ(level_words(terms, false), "2 of 6, fixed");
    }
    terms.cost = 3.0;
    EXPECT_EQ(level_words(terms, false), "3 of 6, finer takes too long");
}

TEST(Status, SaysAllTermsOfTheLevel) {
    HandState hand;
    hand.level_terms = {3.0, 1.0, 0.5, 16.0, 2.0, 0.0, 4.0, 6.0};
    EXPECT_EQ(value_of(describe(shown(), hand, {}), "Terms"),
              "speed 3, touch 1, set 0.5 to 6, device 2, proxy 0, time 4, safe 6");
}

TEST(Status, NumbersThatLookTheSameGiveTheSameStatus) {
    HandState a, b;
    a.level = 1.01;
    b.level = 1.02;
    EXPECT_EQ(describe(shown(), a, {}), describe(shown(), b, {}));
}

TEST(Status, AStiffnessOnItsWayIsSaidAsItIsFelt) {
    HandState hand;
    hand.stiffness_N_per_m = 420.0;
    EXPECT_EQ(value_of(describe(shown(), hand, {}), "Firmness"), "420 N/m");
}

TEST(Status, NothingIsLeftUnnamedBeforeTheFirstPicture) {
    LiveFacts facts;
    facts.hand_words = "mouse";
    const Status status = describe(facts, {}, {});
    EXPECT_EQ(status.title, "No picture yet");
    for (const StatusLine& line : status.lines) EXPECT_FALSE(line.value.empty()) << line.name;
}

TEST(Status, AMessageIsShownWhereNoFaultIs) {
    LiveFacts facts = shown();
    facts.message = "why";
    EXPECT_EQ(describe(facts, {}, {}).message, "why");
}

TEST(Status, AFaultIsTheMessageAndTheStateOfTheMotorsIsSaid) {
    ForceStatus force;
    force.state = ForceState::live;
    EXPECT_EQ(value_of(describe(shown(), {}, force), "Motors"), "on");
    force.limit = Limit::heat;
    EXPECT_EQ(value_of(describe(shown(), {}, force), "Force"), "0.0 N, less: the motors are warm");
    force = {ForceState::fault, Fault::device_lost, Limit::fault, {}};
    const Status status = describe(shown(), {}, force);
    EXPECT_EQ(value_of(status, "Motors"), "stopped");
    EXPECT_EQ(status.message,
              "The force is off. The device does not answer. Please ask the staff to check its "
              "cable. Once it answers, the voice tells you where to move the handle. You can go on "
              "exploring without force.");
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
