#include "app/visit/status.h"

#include "app/visit/keys.h"
#include "app/visit/told_lines.h"

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

TEST(Status, AHandOfWhichNothingIsKnownHasNoLine) {
    LiveFacts facts = shown();
    const auto has_hand = [](const Status& status) {
        return std::ranges::any_of(status.lines,
                                   [](const StatusLine& line) { return line.name == "Hand"; });
    };
    EXPECT_TRUE(has_hand(describe(facts, {}, {}, Language())));
    facts.hand_words.clear();
    EXPECT_FALSE(has_hand(describe(facts, {}, {}, Language())));
}

TEST(Status, SaysContactLevelForceAndMode) {
    HandState hand;
    hand.state = ContactState::vertex;
    hand.level = 2.46;
    hand.force = {0.6, -0.8};
    const Status status = describe(shown(), hand, {}, Language());
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
        return value_of(describe(facts, {}, {}, Language()), "Picture");
    };
    EXPECT_EQ(page_of({2, 7, 1, 4}), "Page 2 of 7. Picture 1 of 3 on this page");
    EXPECT_EQ(page_of({2, 7, 4, 4}), "Page 2 of 7. The whole page");
    EXPECT_EQ(page_of({1, 1, 1, 2}), "Picture 1 of 1 on this page");
    EXPECT_EQ(page_of({2, 7, 1, 1}), "Page 2 of 7");
    EXPECT_EQ(page_of({1, 1, 1, 1}), "");
}

TEST(Status, SaysTheLastEventInWords) {
    const auto last_words = [](const std::optional<ContactEvent>& last) {
        LiveFacts facts = shown();
        facts.last = last;
        return value_of(describe(facts, {}, {}, Language()), "Last");
    };
    EXPECT_EQ(last_words({}), "nothing yet");
    ContactEvent event;
    event.kind = ContactEventKind::line_crossed;
    EXPECT_EQ(last_words(event), "crossed a line");
    std::set<std::string> words;
    for (std::size_t kind = 0; kind < contact_event_count; ++kind) {
        event.kind = static_cast<ContactEventKind>(kind);
        words.insert(last_words(event));
    }
    EXPECT_EQ(words.size(), contact_event_count);
    EXPECT_FALSE(words.contains(""));
}

TEST(Status, SaysThatAWallGivesWay) {
    LiveFacts facts = shown();
    facts.has_pop_through = true;
    HandState hand;
    hand.mode = Mode::groove;
    EXPECT_EQ(value_of(describe(facts, hand, {}, Language()), "Kind of line"), "groove");
    hand.mode = Mode::wall;
    EXPECT_EQ(value_of(describe(facts, hand, {}, Language()), "Kind of line"),
              "wall, gives way to a push");
}

std::string level_words(const LevelTerms& terms, bool is_automatic) {
    HandState hand;
    hand.level_terms = terms;
    hand.level = choose_level(terms).level;
    hand.is_level_auto = is_automatic;
    return value_of(describe(shown(), hand, {}, Language()), "Level");
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
    EXPECT_EQ(value_of(describe(shown(), hand, {}, Language()), "Terms"),
              "speed 3, touch 1, set 0.5 to 6, device 2, proxy 0, time 4, safe 6");
}

TEST(Status, NumbersThatLookTheSameGiveTheSameStatus) {
    HandState a, b;
    a.level = 1.01;
    b.level = 1.02;
    EXPECT_EQ(describe(shown(), a, {}, Language()), describe(shown(), b, {}, Language()));
}

TEST(Status, AStiffnessOnItsWayIsSaidAsItIsFelt) {
    HandState hand;
    hand.stiffness_N_per_m = 420.0;
    EXPECT_EQ(value_of(describe(shown(), hand, {}, Language()), "Firmness"),
              "420 newtons per metre");
}

TEST(Status, NothingIsLeftUnnamedBeforeTheFirstPicture) {
    LiveFacts facts;
    facts.hand_words = "mouse";
    const Status status = describe(facts, {}, {}, Language());
    EXPECT_EQ(status.title, "No picture yet");
    for (const StatusLine& line : status.lines) EXPECT_FALSE(line.value.empty()) << line.name;
}

TEST(Status, AMessageIsShownWhereNoFaultIs) {
    LiveFacts facts = shown();
    facts.message = "why";
    EXPECT_EQ(describe(facts, {}, {}, Language()).message, "why");
}

TEST(Status, AFaultIsTheMessageAndTheStateOfTheMotorsIsSaid) {
    ForceStatus force;
    force.state = ForceState::live;
    EXPECT_EQ(value_of(describe(shown(), {}, force, Language()), "Motors"), "on");
    force.limit = Limit::heat;
    EXPECT_EQ(value_of(describe(shown(), {}, force, Language()), "Force"),
              "0.0 N, less: the motors are warm");
    force = {ForceState::fault, Fault::device_lost, Limit::fault, {}};
    const Status status = describe(shown(), {}, force, Language());
    EXPECT_EQ(value_of(status, "Motors"), "stopped");
    EXPECT_EQ(status.message, staffs_fault(Fault::device_lost, Language()));
}

TEST(Status, TheHandIsTheDeviceByItsNumberInEachLanguage) {
    LiveFacts facts = shown();
    facts.hand_words = "device {0}";
    facts.hand_name = "2diy-gen3 0042";
    EXPECT_EQ(value_of(describe(facts, {}, {}, Language()), "Hand"), "device 2diy-gen3 0042");
    const Language german = Language::load(TOUCHLINE_CATALOGUES, "de").value();
    const Status told = describe(facts, {}, {}, german);
    EXPECT_EQ(told.lines.back().value, "Gerät 2diy-gen3 0042");
}

/// Expects every value except numbers to differ from the English one.
void expect_translated(const LiveFacts& facts, const HandState& hand, const ForceStatus& force,
                       const Language& language) {
    const Status english = describe(facts, hand, force, Language());
    const Status told = describe(facts, hand, force, language);
    ASSERT_EQ(told.lines.size(), english.lines.size());
    for (std::size_t i = 0; i < told.lines.size(); ++i) {
        const std::string& value = english.lines[i].value;
        const bool is_number = value.find_first_not_of("0123456789.,- N") == std::string::npos;
        if (!is_number) {
            EXPECT_NE(told.lines[i].value, value) << language.code();
        }
    }
    EXPECT_NE(told.title, english.title);
}

/// Gives each reason for a level once.
std::vector<LevelTerms> terms_that_decide() {
    return {{.speed = 3.0},   {.percept = 2.0}, {.finest = 2.0}, {.speed = 3.0, .coarsest = 1.0},
            {.encoder = 1.0}, {.radius = 1.0},  {.cost = 4.0},   {.speed = 9.0, .safe = 5.0}};
}

/// Returns all languages of the catalogue folder except English.
std::vector<Language> translations() {
    std::vector<Language> all;
    const auto codes = languages_in(TOUCHLINE_CATALOGUES).value();
    for (const std::string& code : codes)
        if (code != "en") all.push_back(Language::load(TOUCHLINE_CATALOGUES, code).value());
    return all;
}

TEST(Status, IsAllInTheOperatorsLanguage) {
    ASSERT_GE(translations().size(), 3U);
    for (const Language& language : translations()) {
        LiveFacts facts;
        facts.hand_words = "mouse, no device";
        facts.place = {2, 7, 1, 4};
        for (std::size_t kind = 0; kind < contact_event_count; ++kind) {
            facts.last = ContactEvent{};
            facts.last->kind = static_cast<ContactEventKind>(kind);
            expect_translated(facts, {}, {}, language);
        }
        facts.last.reset();
        facts.has_pop_through = true;
        HandState hand;
        for (const LevelTerms& terms : terms_that_decide()) {
            hand.level_terms = terms;
            expect_translated(facts, hand, {}, language);
        }
        hand.is_level_auto = false;
        expect_translated(facts, hand, {}, language);
        for (int state = 0; state < 3; ++state) {
            hand.state = static_cast<ContactState>(state);
            expect_translated(facts, hand, {}, language);
        }
        for (const Mode mode : {Mode::wall, Mode::groove, Mode::ridge, Mode::stay}) {
            hand.mode = mode;
            expect_translated(facts, hand, {}, language);
        }
        for (const bool is_placed : {true, false}) {
            hand.shape = HeldShape::bar;
            hand.is_shape_placed = is_placed;
            expect_translated(facts, hand, {}, language);
        }
        hand.spring_gain = 0.5;
        expect_translated(facts, hand, {}, language);
        ForceStatus force;
        for (std::size_t i = 0; i < force_state_count * limit_count; ++i) {
            force.state = static_cast<ForceState>(i % force_state_count);
            force.limit = static_cast<Limit>(i / force_state_count);
            expect_translated(facts, hand, force, language);
        }
        for (facts.detail = 2; facts.detail <= 5; ++facts.detail)
            expect_translated(facts, hand, {}, language);
    }
}

TEST(Status, NumbersHaveTheSignOfTheLanguage) {
    const Language german = Language::load(TOUCHLINE_CATALOGUES, "de").value();
    HandState hand;
    hand.level = 2.46;
    hand.force = {0.6, -0.8};
    const Status status = describe(shown(), hand, {}, german);
    EXPECT_EQ(value_of(status, "Kraft"), "1,0 Newton");
    EXPECT_EQ(value_of(status, "Stufe").substr(0, 9), "2,5 von 6");
}

std::string keys_as_markdown() {
    std::string text = "| key | what it does |\n|---|---|\n";
    for (const KeyRow& row : key_table())
        text += "| " + std::string(row.name) + " | " + std::string(row.words) + " |\n";
    return text;
}

TEST(Status, TheReadmeHoldsTheKeyTableAsItIs) {
    std::ifstream file(TOUCHLINE_SOURCE_DIR "/app/visit/README.md");
    std::stringstream text;
    text << file.rdbuf();
    EXPECT_NE(text.str().find(keys_as_markdown()), std::string::npos)
        << "app/visit/README.md must hold exactly:\n"
        << keys_as_markdown();
}

}  // namespace
}  // namespace touchline
