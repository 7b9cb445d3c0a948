// Tests that the keys can do what a text asks for: the six of a keypad, two switches, and a full
// keyboard.
#include "app/operator/operator_menu.h"
#include "app/visit/keys.h"
#include "app/visit/keys/key_wizard.h"
#include "app/visit/keys/two_switches.h"
#include "app/visit/told_lines.h"
#include "tests/app/visit/visit_scenes.h"
#include "tests/audio-cues/words/po_file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

namespace touchline {
namespace {

const std::string catalogue_folder = TOUCHLINE_SOURCE_DIR "/audio-cues/words/catalogue";

struct Layout {
    const char* name;
    SwitchUse two_switches;
    std::vector<KeyRole> roles;  // whose keys can be pressed
    bool is_keyboard;            // with letters
};

const std::vector<Layout>& layouts() {
    using R = KeyRole;
    static const std::vector<R> six{R::up, R::down, R::back, R::repeat, R::select, R::help};
    static const std::vector<R> all{R::up,     R::down, R::back,   R::repeat,
                                    R::select, R::help, R::louder, R::softer};
    static const std::vector<Layout> each{
        {"six keys", SwitchUse::none, six, false},
        {"two switches", SwitchUse::move_and_select, {R::select}, false},
        {"one switch", SwitchUse::by_itself, {R::select}, false},
        {"keyboard", SwitchUse::none, all, true}};
    return each;
}

constexpr std::array<std::string_view, key_role_count> role_names{
    "Up", "Down", "Back", "Repeat", "Select", "Help", "Louder", "Softer"};

std::vector<std::string> words_of(const std::string& text) {
    std::vector<std::string> words;
    std::istringstream stream(text);
    for (std::string word; stream >> word;) {
        while (!word.empty() && std::string_view(".,;:!?").find(word.back()) != std::string::npos)
            word.pop_back();
        words.push_back(word);
    }
    return words;
}

/// Returns what is told and asked, without the names and values of items, which may be called Back.
std::vector<std::string> texts_of(const SpokenScreen& screen) {
    std::vector<std::string> texts{screen.text};
    for (const ScreenItem& item : screen.items) texts.push_back(item.hint);
    return texts;
}

std::set<KeyRole> roles_named_in(const std::string& text) {
    std::set<KeyRole> roles;
    for (const std::string& word : words_of(text)) {
        const auto* const found = std::ranges::find(role_names, word);
        if (found != role_names.end())
            roles.insert(static_cast<KeyRole>(found - role_names.begin()));
    }
    return roles;
}

/// Returns the keys that the switches reach on this screen, one after the other.
std::set<KeyRole> reached_by_switches(const SpokenScreen& screen, const Language& language) {
    std::set<KeyRole> reached{KeyRole::select};
    SwitchScan scan;
    scan.title = screen.title;
    SpokenScreen at = screen;
    for (std::size_t i = 0; i < 2 * screen.items.size() + 8; ++i) {
        const SwitchStep moved = step_switches(scan, SwitchEvent::move, at, 0.0, 0.0, language);
        if (moved.press == KeyRole::down && at.focus) at.focus = move_focus(at, true)->focus;
        scan = moved.scan;
        const SwitchStep taken = step_switches(scan, SwitchEvent::select, at, 0.0, 0.0, language);
        const bool is_item = taken.press == KeyRole::select && at.focus;
        if (is_item && at.items[*at.focus].name == role_in_words(KeyRole::back, language))
            reached.insert(KeyRole::back);
        if (taken.press) reached.insert(*taken.press);
    }
    return reached;
}

std::set<KeyRole> keys_there(const Layout& layout, const SpokenScreen& screen,
                             const Language& language) {
    if (layout.two_switches != SwitchUse::none) return reached_by_switches(screen, language);
    return {layout.roles.begin(), layout.roles.end()};
}

TEST(KeysInTexts, EveryKeyThatAScreenNamesIsThere) {
    std::size_t named = 0;
    for (const Layout& layout : layouts()) {
        FakeHouse house;
        house.settings.two_switches = layout.two_switches;
        std::set<std::string> known;
        for (const Visit& visit : scenes_of_all_screens()) {
            const SpokenScreen screen = screen_of(visit, house.world());
            if (!known.insert(spoken_screen(screen, Language())).second) continue;
            const auto there = keys_there(layout, screen, language_of(visit, house.world()));
            for (const std::string& text : texts_of(screen)) {
                for (const KeyRole role : roles_named_in(text)) {
                    ++named;
                    EXPECT_TRUE(there.contains(role)) << layout.name << ": " << text;
                }
            }
        }
    }
    EXPECT_GT(named, 1000U);
}

/// Returns the keys that step_switches() gives to a visit; Down only if there is an item.
std::vector<KeyRole> presses_of(const Layout& layout, const SpokenScreen& screen) {
    if (layout.two_switches == SwitchUse::none) return layout.roles;
    std::vector<KeyRole> roles{KeyRole::select, KeyRole::repeat, KeyRole::back, KeyRole::help};
    if (!screen.items.empty()) roles.push_back(KeyRole::down);
    return roles;
}

/// Returns presses of the layout's keys, and events that come without a key.
std::vector<VisitEvent> events_at(const Visit& visit, const Layout& layout,
                                  const SpokenScreen& screen) {
    std::vector<VisitEvent> events{DeadKeyPressed{},
                                   StickArriving{},
                                   CameraFailed{},
                                   CameraChanged{false},
                                   Tick{visit.site.now_s + 20.0},
                                   Tick{visit.site.now_s + 200.0},
                                   TroubleBegan{TroubleKind::camera, ""}};
    for (const KeyRole role : presses_of(layout, screen)) events.emplace_back(KeyPressed{role});
    return events;
}

/// Tests what is said on the way from one screen to the next.
TEST(KeysInTexts, EveryKeyThatIsSpokenOfIsThere) {
    std::size_t named = 0;
    for (std::size_t i = 0; i < 2; ++i) {  // one switch reaches what two do; a keyboard has all
        const Layout& layout = layouts()[i];
        FakeHouse house;
        house.settings.two_switches = layout.two_switches;
        const VisitWorld world = house.world();
        for (Visit visit : scenes_of_all_screens()) {
            visit.visitor.caption = {};   // said for a keyboard's keys
            visit.visitor.dead_keys = 2;  // the third dead key is answered in words
            for (const VisitEvent& event : events_at(visit, layout, screen_of(visit, world))) {
                const VisitStep next = step(visit, event, world);
                for (const VisitOrder& order : next.orders) {
                    const auto* const said = std::get_if<Utterance>(&order);
                    const auto roles = said ? roles_named_in(said->text) : std::set<KeyRole>{};
                    if (roles.empty()) continue;
                    const auto there = keys_there(layout, screen_of(next.visit, world),
                                                  language_of(next.visit, world));
                    named += roles.size();
                    for (const KeyRole role : roles)
                        EXPECT_TRUE(there.contains(role)) << layout.name << ": " << said->text;
                }
            }
        }
    }
    EXPECT_GT(named, 1000U);
}

/// No key that a text names is refused, and each has an effect.
TEST(KeysInTexts, EveryKeyThatAScreenNamesDoesSomething) {
    FakeHouse house;
    for (const Visit& visit : scenes_of_all_screens()) {
        const SpokenScreen screen = screen_of(visit, house.world());
        std::set<KeyRole> named = roles_named_in(screen.text);
        if (screen.focus) named.merge(roles_named_in(screen.items[*screen.focus].hint));
        for (const KeyRole role : named) {
            const VisitStep next = step(visit, KeyPressed{role}, house.world());
            const bool is_refused = std::ranges::any_of(next.orders, [](const VisitOrder& order) {
                const auto* const cue = std::get_if<GiveCue>(&order);
                return cue != nullptr && cue->event == ScreenEvent::key_refused;
            });
            EXPECT_FALSE(is_refused) << screen.title << ": " << static_cast<int>(role);
            EXPECT_FALSE(next.orders.empty()) << screen.title << ": " << static_cast<int>(role);
        }
    }
}

/// "call the staff" is an item, one Down list away from any picture, and the staff hear of it.
TEST(KeysInTexts, WhoIsToldToCallTheStaffCan) {
    for (const Layout& layout : layouts()) {
        FakeHouse house;
        house.settings.two_switches = layout.two_switches;
        to_choose(house);
        house.apply(TroubleBegan{TroubleKind::device, spoken_fault(Fault::energy, Language())});
        house.press(KeyRole::select);  // "Go on"
        ASSERT_TRUE(house.choose("Call staff")) << layout.name;
        EXPECT_EQ(house.last<CallStaff>().size(), 1U) << layout.name;
    }
}

TEST(KeysInTexts, WhoIsToldToChooseSofterLinesCan) {
    ASSERT_NE(spoken_fault(Fault::ringing, Language()).find("choose softer lines"),
              std::string::npos);
    FakeHouse house;
    to_picture(house);
    const std::size_t before = house.visit.visitor.feel.stiffness;
    ASSERT_GT(before, 0U);
    ASSERT_TRUE(house.choose("Firmness"));
    ASSERT_TRUE(house.choose(std::string(stiffness_steps.at(before - 1).name)));
    EXPECT_LT(house.visit.visitor.feel.stiffness, before);
}

/// What ends a fault for the staff is an item of their menu, so the six keys are enough.
TEST(KeysInTexts, WhatTheStaffAreToldToChooseIsInTheirMenu) {
    const auto is_item = [](std::string_view name) {
        return std::ranges::any_of(action_rows(),
                                   [name](const ActionRow& row) { return row.name == name; });
    };
    EXPECT_TRUE(is_item("Reset the force fault"));
    EXPECT_TRUE(is_item("Copy the log"));
    EXPECT_TRUE(
        staffs_fault(Fault::energy, Language()).ends_with("Then choose: Reset the force fault."));
    EXPECT_FALSE(staffs_fault(Fault::too_fast, Language()).find("Then choose") != std::string::npos)
        << "it ends by itself";
}

/// Finds a letter of the staff's keys within a sentence, as in "press C", or a key with a name.
std::string keyboard_key_in(const std::string& text) {
    static const std::set<std::string> names{"Space",  "Leertaste", "Espace", "Espacio", "Spazio",
                                             "Enter",  "Eingabe",   "Entrée", "Intro",   "Invio",
                                             "Escape", "Tab",       "Shift"};
    bool is_first = true;
    std::istringstream stream(text);
    for (std::string raw; stream >> raw;) {
        const std::string word = words_of(raw).front();
        const bool is_letter =
            word.size() == 1 && std::ranges::any_of(key_table(), [&word](const KeyRow& row) {
                return word == row.name;
            });
        if (names.contains(word) || (is_letter && !is_first)) return word;
        is_first = raw.ends_with('.') || raw.ends_with(':');
    }
    return {};
}

TEST(KeysInTexts, NoTextForVisitorsNamesAKeyOfAKeyboard) {
    EXPECT_EQ(keyboard_key_in("When all is safe, press C."), "C");
    EXPECT_EQ(keyboard_key_in("A part. A line."), "");
    const std::set<std::string> contexts{"visit", "fault",  "trouble", "device",
                                         "stick", "speech", "page",    "camera"};
    for (const auto& file : std::filesystem::directory_iterator(catalogue_folder)) {
        for (const auto& [key, entry] : read_po(file.path().string())) {
            if (!contexts.contains(key.first)) continue;
            EXPECT_EQ(keyboard_key_in(key.second), "") << key.second;
            for (const std::string& text : entry.said)
                EXPECT_EQ(keyboard_key_in(text), "") << file.path() << ": " << text;
        }
    }
}

}  // namespace
}  // namespace touchline
