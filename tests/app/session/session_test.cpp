#include "app/session/session.h"

#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

constexpr int pictures = 3;
constexpr double felt = 2.4;

Session shown_session() {
    const Session started = start_session(pictures).session;
    return picture_ready(started, started.request, {"Fish", 4, 6, ""}).session;
}

std::vector<Key> every_key() {
    std::vector<Key> keys{Key::unknown, Key{'T'}};
    for (const KeyRow& row : key_table()) {
        for (auto k = static_cast<std::uint32_t>(row.first); Key{k} <= row.last; ++k)
            keys.push_back(Key{k});
    }
    return keys;
}

/// Every kind of state that a key can meet.
std::vector<Session> every_state() {
    const Session empty = start_session(0).session;
    const Session loading = start_session(pictures).session;
    const Session shown = shown_session();
    const Session reloading = press_key(shown, Key::right, felt).session;
    const Session failed = picture_failed(reloading, reloading.request, "bad file").session;
    const Session failed_first = picture_failed(loading, loading.request, "bad file").session;
    Session fixed = press_key(shown, Key{'L'}, felt).session;
    fixed.shows_boxes = fixed.shows_keys = true;
    return {empty, loading, shown, reloading, failed, failed_first, fixed};
}

void expect_sound(const Session& session) {
    EXPECT_GE(session.picture, 0);
    EXPECT_LT(session.picture, std::max(session.picture_count, 1));
    EXPECT_GE(session.detail, coarsest_detail);
    EXPECT_LE(session.detail, finest_detail);
    EXPECT_GE(session.fixed_level, 0);
    EXPECT_LE(session.fixed_level, session.shown.coarsest_level);
    EXPECT_LT(session.stiffness, stiffness_steps.size());
}

TEST(Keys, NoKeyHasTwoMeanings) {
    std::set<Key> seen;
    for (const KeyRow& row : key_table()) {
        for (auto k = static_cast<std::uint32_t>(row.first); Key{k} <= row.last; ++k)
            EXPECT_TRUE(seen.insert(Key{k}).second) << row.name;
    }
}

TEST(Keys, EveryRowHasWordsForTheOverlayAndTheReadme) {
    const std::string text = keys_as_markdown();
    for (const KeyRow& row : key_table()) {
        EXPECT_FALSE(row.name.empty());
        EXPECT_NE(text.find(std::string(row.words)), std::string::npos);
    }
}

TEST(Keys, UnknownKeysHaveNoMeaning) {
    EXPECT_FALSE(action_of(Key::unknown).has_value());
    EXPECT_FALSE(action_of(Key{'T'}).has_value());
}

TEST(Keys, DigitsGiveTheirPlaceInTheRow) {
    EXPECT_EQ(action_of(Key{'4'})->action, Action::set_detail);
    EXPECT_EQ(action_of(Key{'4'})->argument, 3);
}

TEST(Session, StartsByLoadingTheFirstPicture) {
    const Step step = start_session(pictures);
    EXPECT_TRUE(step.commands.load);
    EXPECT_TRUE(step.commands.feel);
    EXPECT_TRUE(step.session.is_loading);
    EXPECT_EQ(step.session.picture, 0);
    EXPECT_EQ(step.session.mode, Mode::groove);
}

TEST(Session, AnEmptyListLoadsNothing) {
    const Step step = start_session(0);
    EXPECT_FALSE(step.commands.load);
    EXPECT_FALSE(press_key(step.session, Key::right, felt).commands.load);
}

TEST(Session, EveryKeyInEveryStateKeepsTheStateSound) {
    for (const Session& state : every_state()) {
        for (const Key key : every_key()) expect_sound(press_key(state, key, felt).session);
    }
}

bool turns_pages(Action action) {
    return action == Action::next_view || action == Action::previous_view ||
           action == Action::next_page || action == Action::previous_page;
}

TEST(Session, EveryKeyDoesTheSameInEveryState) {
    for (const Session& state : every_state()) {
        for (const Key key : every_key()) {
            if (const auto turns = action_of(key); turns && turns_pages(turns->action)) continue;
            const Commands commands = press_key(state, key, felt).commands;
            const auto pressed = action_of(key);
            const bool loads = pressed && (pressed->action == Action::next_picture ||
                                           pressed->action == Action::previous_picture ||
                                           pressed->action == Action::set_detail);
            const bool feels =
                pressed &&
                (pressed->action == Action::toggle_level_automatic ||
                 pressed->action == Action::coarser_level ||
                 pressed->action == Action::finer_level || pressed->action == Action::firmer ||
                 pressed->action == Action::softer || pressed->action == Action::next_mode ||
                 pressed->action == Action::toggle_pop_through ||
                 pressed->action == Action::toggle_force ||
                 pressed->action == Action::emergency_stop ||
                 pressed->action == Action::clear_fault);
            EXPECT_EQ(commands.load, loads && state.picture_count > 0);
            EXPECT_EQ(commands.feel, feels);
            EXPECT_EQ(commands.keep_recording,
                      pressed && pressed->action == Action::keep_recording);
            const bool is_of_sound = pressed && pressed->action >= Action::next_sounds &&
                                     pressed->action <= Action::headphones_out;
            EXPECT_EQ(commands.sound, is_of_sound ? std::optional(pressed->action) : std::nullopt);
            EXPECT_EQ(commands.quit, pressed && pressed->action == Action::quit);
        }
    }
}

/// The picture that is shown, as a document: page 2 of 3, its first of two pictures.
Session document_session() {
    const Session started = start_session(pictures).session;
    return picture_ready(started, started.request, {"Book", 4, 6, "", {2, 3, 1, 3}}).session;
}

Session pressed(Session session, const std::string& keys) {
    for (const char key : keys)
        session = press_key(session, Key{static_cast<std::uint32_t>(key)}, felt).session;
    return session;
}

TEST(Session, KGoesThroughPicturesPageAndPages) {
    const Session book = document_session();
    const PagePlace second{2, 3, 2, 3};
    EXPECT_EQ(pressed(book, "K").place, second);
    const PagePlace whole{2, 3, 3, 3};
    EXPECT_EQ(pressed(book, "KK").place, whole);
    const PagePlace next{3, 3, 1, 0};
    EXPECT_EQ(pressed(book, "KKK").place, next);
    const PagePlace before{1, 3, last_view, 0};
    EXPECT_EQ(pressed(book, "J").place, before);
    EXPECT_TRUE(press_key(book, Key{'K'}, felt).commands.load);
}

TEST(Session, BeginsAsTheOperatorSet) {
    Settings settings;
    settings.mode = static_cast<int>(Mode::ridge);
    settings.stiffness_N_per_m = 380.0;
    settings.detail = 2;
    settings.gives_way = true;
    settings.is_level_automatic = false;
    settings.fixed_level = 3;
    const Session session = start_session(pictures, 700.0, settings).session;
    EXPECT_EQ(session.mode, Mode::ridge);
    EXPECT_EQ(stiffness_steps[session.stiffness].name, "soft");
    EXPECT_EQ(session.detail, 2);
    EXPECT_TRUE(session.is_pop_through);
    EXPECT_FALSE(session.is_level_automatic);
    EXPECT_EQ(session.fixed_level, 3);
}

TEST(Session, IAndUGoByPages) {
    const Session book = document_session();
    const PagePlace next{3, 3, 1, 0};
    const PagePlace before{1, 3, 1, 0};
    EXPECT_EQ(pressed(book, "I").place, next);
    EXPECT_EQ(pressed(book, "U").place, before);
}

TEST(Session, AtTheEndsOfADocumentNothingChangesAndASentenceSaysSo) {
    const Session book = document_session();
    for (const auto& [keys, line] :
         {std::pair("II", "This is the last page."), std::pair("UU", "This is the first page.")}) {
        const Session at_end = pressed(book, std::string(1, keys[0]));
        const Step step = press_key(at_end, Key{static_cast<std::uint32_t>(keys[1])}, felt);
        EXPECT_FALSE(step.commands.load);
        EXPECT_EQ(step.session.place, at_end.place);
        EXPECT_EQ(step.session.message, line);
    }
    for (const char key : std::string("KJIU")) {
        const Key pressed_key{static_cast<std::uint32_t>(key)};
        const Step step = press_key(shown_session(), pressed_key, felt);  // one page, one view
        EXPECT_FALSE(step.commands.load);
        EXPECT_FALSE(step.session.message.empty());
    }
}

TEST(Session, WhileAPageIsOpenedItsViewsAreBelieved) {
    const Session book = pressed(document_session(), "I");
    const PagePlace third{3, 3, 3, 0};
    EXPECT_EQ(pressed(book, "KK").place, third);
}

TEST(Session, APageThatFailedIsPassedOver) {
    Session book = pressed(document_session(), "U");
    book = picture_failed(book, book.request, "torn", {1, 0, 1, 0}).session;
    const PagePlace next{2, 3, 1, 0};
    EXPECT_EQ(pressed(book, "I").place, next);
    EXPECT_EQ(pressed(book, "K").place, next);
}

TEST(Session, AFailureTellsHowManyPagesThereAre) {
    Session book = start_session(pictures).session;
    book = picture_failed(book, book.request, "no outline", {1, 5, 1, 2}).session;
    const PagePlace view{1, 5, 2, 2};
    EXPECT_EQ(pressed(book, "K").place, view);
    const PagePlace next{2, 5, 1, 0};
    EXPECT_EQ(pressed(book, "I").place, next);
}

TEST(Session, AnotherPictureBeginsAtItsFirstPage) {
    EXPECT_EQ(press_key(document_session(), Key::right, felt).session.place, PagePlace{});
    EXPECT_EQ(pressed(document_session(), "K5").place, (PagePlace{2, 3, 2, 3}));
}

TEST(Session, AListThatChangesMovesNothing) {
    const Session shown = shown_session();
    const Step step = list_changed(shown, {pictures + 4, 4, 4});
    EXPECT_FALSE(step.commands.load);
    EXPECT_EQ(step.session.shown.number, 5);
    EXPECT_EQ(step.session.picture, 4);
    EXPECT_EQ(press_key(step.session, Key::right, felt).session.picture, 5);
}

TEST(Session, APictureThatLeftTheListIsStillFelt) {
    const Session gone = list_changed(shown_session(), {2, std::nullopt, std::nullopt}).session;
    EXPECT_EQ(gone.shown.number, 0);
    EXPECT_EQ(gone.shown.title, "Fish");
    EXPECT_TRUE(press_key(gone, Key{'5'}, felt).commands.load);
    EXPECT_FALSE(press_key(gone, Key{'5'}, felt).session.is_listed);
    EXPECT_EQ(press_key(gone, Key::right, felt).session.picture, 0);
    EXPECT_EQ(press_key(gone, Key::left, felt).session.picture, 1);
    EXPECT_TRUE(press_key(gone, Key::left, felt).session.is_listed);
    Session again = press_key(gone, Key{'5'}, felt).session;
    again = picture_ready(again, again.request, {"Fish", 9, 6, ""}).session;
    EXPECT_EQ(again.shown.number, 0);
}

TEST(Session, AnEmptyListThatIsFilledCanBeChosenFrom) {
    const Session filled =
        list_changed(start_session(0).session, {2, std::nullopt, std::nullopt}).session;
    const Step step = choose_picture(filled, 0);
    EXPECT_TRUE(step.commands.load);
    EXPECT_EQ(step.session.picture, 0);
    EXPECT_TRUE(step.session.is_listed);
}

TEST(Session, WhatIsToldWhileAPictureLoadsStays) {
    Session session = tell(start_session(pictures).session, "And 20 more.").session;
    session = picture_ready(session, session.request, {"Fish", 4, 6, ""}).session;
    EXPECT_EQ(session.message, "And 20 more.");
}

TEST(Session, ForceGoesOffAndOnAndFaultsAreClearedOneByOne) {
    const Session on = shown_session();
    const Session off = press_key(on, Key{' '}, felt).session;
    EXPECT_TRUE(on.is_force_wanted);
    EXPECT_FALSE(off.is_force_wanted);
    EXPECT_TRUE(press_key(off, Key{' '}, felt).session.is_force_wanted);
    EXPECT_EQ(press_key(on, Key{'C'}, felt).session.faults_cleared, on.faults_cleared + 1);
}

TEST(Session, TheEmergencyStopHoldsThroughEveryKeyUntilItIsCleared) {
    const Session stopped = press_key(shown_session(), Key{'E'}, felt).session;
    EXPECT_TRUE(stopped.is_emergency_stop);
    for (const Key key : every_key()) {
        const bool clears = key == Key{'C'};
        EXPECT_EQ(press_key(stopped, key, felt).session.is_emergency_stop, !clears);
    }
}

TEST(Session, PicturesWrapAround) {
    const Session shown = shown_session();
    EXPECT_EQ(press_key(shown, Key::left, felt).session.picture, pictures - 1);
    Session session = shown;
    for (int i = 0; i < pictures; ++i) session = press_key(session, Key::right, felt).session;
    EXPECT_EQ(session.picture, shown.picture);
}

TEST(Session, DigitsChooseTheDetailOfTheSamePicture) {
    const Step step = press_key(shown_session(), Key{'5'}, felt);
    EXPECT_EQ(step.session.detail, 5);
    EXPECT_EQ(step.session.picture, 0);
    EXPECT_TRUE(step.commands.load);
}

TEST(Session, ANewListEntryKeepsTheDetail) {
    const Session detailed = press_key(shown_session(), Key{'5'}, felt).session;
    EXPECT_EQ(press_key(detailed, Key::right, felt).session.detail, 5);
}

TEST(Session, FixingTheLevelKeepsWhatIsFelt) {
    const Session fixed = press_key(shown_session(), Key{'L'}, felt).session;
    EXPECT_FALSE(fixed.is_level_automatic);
    EXPECT_EQ(fixed.fixed_level, 2);
    EXPECT_TRUE(press_key(fixed, Key{'L'}, felt).session.is_level_automatic);
}

TEST(Session, PageKeysStepFromTheLevelFeltAndStayInRange) {
    const Session shown = shown_session();
    EXPECT_EQ(press_key(shown, Key::page_up, felt).session.fixed_level, 3);
    EXPECT_EQ(press_key(shown, Key::page_down, felt).session.fixed_level, 1);
    Session session = shown;
    for (int i = 0; i < 20; ++i) session = press_key(session, Key::page_up, felt).session;
    EXPECT_EQ(session.fixed_level, 6);
    for (int i = 0; i < 20; ++i) session = press_key(session, Key::page_down, felt).session;
    EXPECT_EQ(session.fixed_level, 0);
}

TEST(Session, ALevelThatIsNotANumberBecomesTheFinest) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(press_key(shown_session(), Key{'L'}, nan).session.fixed_level, 0);
    EXPECT_EQ(press_key(shown_session(), Key::page_up, nan).session.fixed_level, 0);
}

TEST(Session, StiffnessStopsAtBothEnds) {
    Session session = shown_session();
    for (int i = 0; i < 10; ++i) session = press_key(session, Key::up, felt).session;
    EXPECT_EQ(session.stiffness, stiffness_steps.size() - 1);
    for (int i = 0; i < 10; ++i) session = press_key(session, Key::down, felt).session;
    EXPECT_EQ(session.stiffness, 0u);
}

TEST(Session, StiffnessStepsRise) {
    for (std::size_t i = 1; i < stiffness_steps.size(); ++i)
        EXPECT_GT(stiffness_steps[i].stiffness_N_per_m, stiffness_steps[i - 1].stiffness_N_per_m);
}

TEST(Session, StartsAsFirmAsLoopAndGrooveAllow) {
    const auto first_N_per_m = [](double loop_N_per_m) {
        const Session session = start_session(pictures, loop_N_per_m).session;
        return stiffness_steps[session.stiffness].stiffness_N_per_m;
    };
    EXPECT_EQ(first_N_per_m(760.0), 500.0);   // the default device at 1 kHz: the groove's limit
    EXPECT_EQ(first_N_per_m(1500.0), 500.0);  // a quicker loop: the same
    EXPECT_EQ(first_N_per_m(380.0), 350.0);   // at 500 Hz: the loop's
    EXPECT_EQ(first_N_per_m(100.0), 200.0);
    EXPECT_EQ(first_N_per_m(std::numeric_limits<double>::quiet_NaN()), 200.0);
}

TEST(Session, ModesFollowEachOtherInACircle) {
    Session session = shown_session();
    std::set<Mode> modes;
    for (int i = 0; i < 4; ++i) {
        modes.insert(session.mode);
        session = press_key(session, Key{'M'}, felt).session;
    }
    EXPECT_EQ(modes.size(), 4u);
    EXPECT_EQ(session.mode, Mode::groove);
}

TEST(Session, AWallGivesWayOnlyWhenAsked) {
    const Session shown = shown_session();
    EXPECT_FALSE(shown.is_pop_through);
    const Step asked = press_key(shown, Key{'P'}, felt);
    EXPECT_TRUE(asked.session.is_pop_through);
    EXPECT_TRUE(asked.commands.feel);
    EXPECT_FALSE(press_key(asked.session, Key{'P'}, felt).session.is_pop_through);
}

TEST(Session, BoxesAndKeysAreSwitches) {
    const Session shown = shown_session();
    const Session boxes = press_key(shown, Key{'B'}, felt).session;
    EXPECT_TRUE(boxes.shows_boxes);
    EXPECT_FALSE(press_key(boxes, Key{'B'}, felt).session.shows_boxes);
    EXPECT_TRUE(press_key(shown, Key{'H'}, felt).session.shows_keys);
}

TEST(Session, AFailedPictureLeavesTheOldOneAndSaysWhy) {
    const Session wanted = press_key(shown_session(), Key::right, felt).session;
    const Session failed = picture_failed(wanted, wanted.request, "bad.png: truncated").session;
    EXPECT_EQ(failed.message, "bad.png: truncated");
    EXPECT_EQ(failed.shown.number, 1);
    EXPECT_FALSE(failed.is_loading);
    const Session next = press_key(failed, Key::right, felt).session;
    EXPECT_EQ(next.picture, 2);
    EXPECT_TRUE(next.message.empty());
}

TEST(Session, WhatIsWorthTellingAboutAPictureIsTold) {
    const Session wanted = press_key(shown_session(), Key::right, felt).session;
    const LoadedFacts facts{"Noise", 40, 3, "Only the 40 longest outlines are kept."};
    EXPECT_EQ(picture_ready(wanted, wanted.request, facts).session.message, facts.note);
}

TEST(Session, AJobThatIsNoLongerWantedChangesNothing) {
    const Session first = start_session(pictures).session;
    const Session second = press_key(first, Key::right, felt).session;
    const Step late = picture_ready(second, first.request, {"Old", 1, 1, ""});
    EXPECT_TRUE(late.session.is_loading);
    EXPECT_EQ(late.session.shown.number, 0);
    EXPECT_FALSE(late.commands.feel);
    EXPECT_TRUE(picture_failed(second, first.request, "old").session.message.empty());
}

TEST(Session, AFixedLevelIsCutToWhatTheNewPictureHas) {
    Session session = shown_session();
    for (int i = 0; i < 6; ++i) session = press_key(session, Key::page_up, felt).session;
    session = press_key(session, Key::right, felt).session;
    session = picture_ready(session, session.request, {"Square", 1, 2, ""}).session;
    EXPECT_EQ(session.fixed_level, 2);
}

RC_GTEST_PROP(Session, AnyRunOfKeysAndJobsKeepsTheStateSound, ()) {
    const auto keys = every_key();
    Session session = start_session(*rc::gen::inRange(0, 5)).session;
    const auto moves = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 60));
    for (const int move : moves) {
        const auto choice = static_cast<std::size_t>(move);
        if (choice < keys.size())
            session = press_key(session, keys[choice], move * 0.3).session;
        else if (move % 3 == 0)
            session = picture_ready(session, session.request,
                                    {"", 1, 4, "", {std::max(session.place.page, 1), 9, 1, 3}})
                          .session;
        else if (move % 3 == 1)
            session = list_changed(session, {move % 5, std::nullopt, std::nullopt}).session;
        else
            session = picture_failed(session, session.request, "no").session;
        RC_ASSERT(session.fixed_level <= session.shown.coarsest_level);
        RC_ASSERT(session.picture >= 0);
        RC_ASSERT(session.picture < std::max(session.picture_count, 1));
        RC_ASSERT(session.place.page >= 1 && session.place.view >= 1);
        RC_ASSERT(session.place.page <= std::max(session.place.page_count, 1));
        RC_ASSERT(session.stiffness < stiffness_steps.size());
    }
}

}  // namespace
}  // namespace touchline
