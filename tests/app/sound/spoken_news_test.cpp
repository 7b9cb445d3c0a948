#include "app/sound/spoken_news.h"

#include "app/session/keys.h"

#include <gtest/gtest.h>

namespace touchline {
namespace {

SpokenState started() {
    SpokenState state;
    state.session = start_session(5).session;
    return state;
}

SpokenState with_picture(const std::string& title = "A house", int outlines = 3) {
    SpokenState state = started();
    state.session =
        picture_ready(state.session, state.session.request, {title, outlines, 4, ""}).session;
    return state;
}

SpokenState pressed(SpokenState state, Key key) {
    state.session = press_key(state.session, key, 2.0).session;
    return state;
}

std::vector<std::string> texts(const SpokenState& before, const SpokenState& now,
                               const Language& language = Language()) {
    std::vector<std::string> said;
    for (const Utterance& utterance : spoken_news(before, now, language))
        said.push_back(utterance.text);
    return said;
}

using Texts = std::vector<std::string>;

TEST(SpokenNews, WhereNothingChangesNothingIsSaid) {
    EXPECT_TRUE(texts(with_picture(), with_picture()).empty());
    EXPECT_EQ(screen_event(with_picture(), with_picture()), std::nullopt);
}

TEST(SpokenNews, APictureIsAnnouncedAndThenNamed) {
    const SpokenState before = with_picture();
    const SpokenState loading = pressed(before, Key::right);
    EXPECT_EQ(texts(before, loading), Texts{"Opening picture 2 ..."});
    SpokenState ready = loading;
    ready.session =
        picture_ready(loading.session, loading.session.request, {"A fish", 1, 4, ""}).session;
    EXPECT_EQ(texts(loading, ready), Texts{"A fish. 1 outline."});
    EXPECT_EQ(screen_event(loading, ready), ScreenEvent::picture_ready);
}

TEST(SpokenNews, APictureThatFailsSaysWhyInEnglish) {
    const SpokenState loading = pressed(with_picture(), Key::right);
    SpokenState failed = loading;
    failed.session =
        picture_failed(loading.session, loading.session.request, "x.png: is no picture.").session;
    const auto de = Language::load(TOUCHLINE_CATALOGUES, "de");
    ASSERT_TRUE(de);
    const auto news = spoken_news(loading, failed, *de);
    ASSERT_EQ(news.size(), 1U);
    EXPECT_EQ(news[0].language, "en");
    EXPECT_EQ(news[0].text, "x.png: is no picture.");
    EXPECT_EQ(screen_event(loading, failed), ScreenEvent::picture_failed);
}

TEST(SpokenNews, ADocumentTellsPageAndPicture) {
    SpokenState before = with_picture();
    before.session.place = before.session.shown.place = {1, 3, 1, 3};
    const SpokenState loading = pressed(before, Key{'I'});
    EXPECT_EQ(texts(before, loading), Texts{"Opening page 2 ..."});
    SpokenState ready = loading;
    LoadedFacts facts{"A book", 4, 4, ""};
    facts.place = {2, 3, 2, 3};
    ready.session = picture_ready(loading.session, loading.session.request, facts).session;
    EXPECT_EQ(texts(loading, ready),
              Texts{"A book. Page 2 of 3. Picture 2 of 2 on it. 4 outlines."});
    facts.place = {2, 3, 3, 3};
    ready.session = picture_ready(loading.session, loading.session.request, facts).session;
    EXPECT_EQ(texts(loading, ready), Texts{"A book. Page 2 of 3. The whole page. 4 outlines."});
}

TEST(SpokenNews, WhatTheSessionTellsIsSaidInTheLanguageThatHasIt) {
    SpokenState before = with_picture();
    before.session.place = before.session.shown.place = {3, 3, 1, 1};
    const SpokenState now = pressed(before, Key{'I'});
    EXPECT_EQ(texts(before, now), Texts{"This is the last page."});
    const auto de = Language::load(TOUCHLINE_CATALOGUES, "de");
    ASSERT_TRUE(de);
    const auto news = spoken_news(before, now, *de);
    ASSERT_EQ(news.size(), 1U);
    EXPECT_EQ(news[0].language, "de");
    EXPECT_EQ(news[0].text, "Das ist die letzte Seite.");
}

TEST(SpokenNews, EveryChoiceIsSaid) {
    const SpokenState before = with_picture();
    EXPECT_EQ(texts(before, pressed(before, Key{'M'})), Texts{"Mode: ridge."});
    EXPECT_EQ(texts(before, pressed(before, Key::up)), Texts{"Stiffness: firm."});
    EXPECT_EQ(texts(before, pressed(before, Key{'L'})), Texts{"Level: 2 of 4, fixed."});
    const SpokenState fixed = pressed(before, Key{'L'});
    EXPECT_EQ(texts(fixed, pressed(fixed, Key{'L'})), Texts{"Level: by speed."});
    EXPECT_EQ(texts(fixed, pressed(fixed, Key::page_up)), Texts{"Level: 3 of 4, fixed."});
    EXPECT_EQ(texts(before, pressed(before, Key{' '})), Texts{"Force: off."});
    EXPECT_EQ(texts(pressed(before, Key{' '}), before), Texts{"Force: on."});
    EXPECT_EQ(texts(before, pressed(before, Key{'2'})),
              Texts{"Detail: 2 of 5, main parts. Opening picture 1 ..."});
}

TEST(SpokenNews, AWallThatGivesWayIsSaid) {
    SpokenState wall = with_picture();
    wall.session.mode = Mode::wall;
    EXPECT_EQ(texts(wall, pressed(wall, Key{'P'})), Texts{"Mode: wall, gives way to a push."});
}

TEST(SpokenNews, TheKeysAreListedOnce) {
    const SpokenState before = with_picture();
    const SpokenState shown = pressed(before, Key{'H'});
    const auto said = texts(before, shown);
    ASSERT_EQ(said.size(), 1U);
    for (const KeyRow& row : key_table()) {
        EXPECT_NE(said[0].find(std::string(row.name) + ": " + std::string(row.words) + "."),
                  std::string::npos)
            << row.name;
    }
    EXPECT_TRUE(texts(shown, pressed(shown, Key{'H'})).empty());
}

TEST(SpokenNews, EveryFaultIsSaidWholeAndAsSafetyInEveryLanguage) {
    for (const char* code : {"en", "de", "fr", "es"}) {
        const auto language = Language::load(TOUCHLINE_CATALOGUES, code);
        ASSERT_TRUE(language);
        for (std::size_t i = 1; i < fault_count; ++i) {
            SpokenState now = with_picture();
            now.force.fault = static_cast<Fault>(i);
            const auto news = spoken_news(with_picture(), now, *language);
            ASSERT_EQ(news.size(), 1U);
            EXPECT_EQ(news[0].priority, SpeechPriority::safety);
            EXPECT_EQ(news[0].language, code);
            EXPECT_GT(std::count(news[0].text.begin(), news[0].text.end(), '.'), 2);
            EXPECT_EQ(screen_event(with_picture(), now), ScreenEvent::fault);
            EXPECT_TRUE(spoken_news(now, now, *language).empty()) << "once";
        }
    }
}

TEST(SpokenNews, WhenAFaultIsOverTheForceIsSaid) {
    SpokenState fault = with_picture();
    fault.force = {ForceState::fault, Fault::too_fast, Limit::fault, {}};
    SpokenState over = with_picture();
    over.force.state = ForceState::armed;
    EXPECT_EQ(texts(fault, over), Texts{"Force: waiting for a free hand."});
}

TEST(SpokenNews, WordsThatLeadTheHandAreSaidAsTheyChange) {
    SpokenState before = with_picture();
    SpokenState now = before;
    now.device_words = "Second, pull the handle towards you.";
    EXPECT_EQ(texts(before, now), Texts{now.device_words});
    EXPECT_TRUE(texts(now, before).empty());
}

TEST(SpokenNews, TheListThatBeginsAnewHasItsSound) {
    SpokenState last = with_picture();
    last.session.picture = 4;
    EXPECT_EQ(screen_event(last, pressed(last, Key::right)), ScreenEvent::list_end);
    EXPECT_EQ(screen_event(with_picture(), pressed(with_picture(), Key::left)),
              ScreenEvent::list_end);
    EXPECT_EQ(screen_event(with_picture(), pressed(with_picture(), Key::right)), std::nullopt);
}

TEST(SpokenNews, NamesOfFilesAreMadeSpeakable) {
    EXPECT_EQ(spoken_title("A house"), "A house");
    EXPECT_EQ(spoken_title("garden-map"), "garden map");
    EXPECT_EQ(spoken_title("IMG_2041"), "I M G 2 0 4 1");
}

}  // namespace
}  // namespace touchline
