// Tests keys, lists and ways in every reachable state: IN of the requirements.
#include "app/visit/visit_menu.h"
#include "tests/app/visit/fake_world.h"
#include "tests/app/visit/visit_scenes.h"

#include <algorithm>
#include <set>
#include <variant>

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(Visit, IN1_SixRolesReachEveryScreenThatKeysCanReach) {
    // Follows the graph by KeyRole alone; volume keys lead nowhere.
    std::set<VisitScreen> reached;
    for (const Visit& visit : scenes_of_all_screens()) reached.insert(open_screen(visit));
    EXPECT_EQ(reached.size(), visit_screen_count);
    for (const KeyRole role : {KeyRole::louder, KeyRole::softer}) {
        FakeHouse house;
        to_picture(house);
        house.press(role);
        EXPECT_EQ(house.open(), VisitScreen::picture);
    }
}

TEST(Visit, IN2_BackNeverLosesThePicture) {
    EXPECT_GT(std::count_if(scenes_of_all_screens().begin(), scenes_of_all_screens().end(),
                            [](const Visit& visit) { return visit.visitor.felt.has_value(); }),
              500);
    EXPECT_EQ(scene_graph().lost, std::vector<std::string>{});
}

TEST(Visit, IN2_AKeyMeansTheSameEverywhere) {
    FakeHouse house;
    for (std::size_t i = 0; i < scene_graph().visits.size(); ++i) {
        Visit visit = scene_graph().visits[i];
        visit.visitor.last_key.reset();  // twice the same key may mean more
        if (!is_visit_on(visit) || visit.visitor.over || visit.visitor.leading) continue;
        const auto after = [&](KeyRole role) {
            return step(visit, KeyPressed{role}, house.world()).visit;
        };
        // Up, Down and Repeat never leave a screen.
        for (const KeyRole role : {KeyRole::up, KeyRole::down, KeyRole::repeat}) {
            EXPECT_EQ(open_screen(after(role)), open_screen(visit));
        }
        EXPECT_EQ(open_screen(after(KeyRole::help)), VisitScreen::help);
        const Visit back = after(KeyRole::back);
        const bool asks = open_screen(visit) == VisitScreen::choose;
        ASSERT_EQ(open_screen(back) == VisitScreen::confirm, asks) << scene_graph().names[i];
        if (!asks) {
            EXPECT_LE(back.visitor.path.size(), visit.visitor.path.size());
        }
    }
}

TEST(Visit, IN3_OnePressAfterAnotherIsAllThatIsEverNeeded) {
    // A press has no length and no end, and a key tells nothing else: the same presses lead to the
    // same place however long each takes.
    const std::vector<KeyRole> keys{KeyRole::select, KeyRole::select, KeyRole::down,
                                    KeyRole::select, KeyRole::down,   KeyRole::select};
    FakeHouse quick;
    FakeHouse slow;
    for (const KeyRole key : keys) {
        quick.press(key);
        quick.wait(0.3);
        slow.press(key);
        slow.wait(29.0);
    }
    EXPECT_EQ(quick.open(), slow.open());
    EXPECT_EQ(quick.visit.visitor.path, slow.visit.visitor.path);
    EXPECT_EQ(quick.open(), VisitScreen::picture);
}

TEST(Visit, IN5_ListsGoRoundWithASoundAndAShake) {
    FakeHouse house;
    to_choose(house);
    house.press(KeyRole::up);
    EXPECT_EQ(house.last<GiveCue>()[0].event, ScreenEvent::list_end);
    EXPECT_EQ(house.last<GivePattern>()[0].pattern, HandlePattern::edge);
    EXPECT_TRUE(house.last_said().starts_with("Finish"));
    house.press(KeyRole::down);
    EXPECT_EQ(house.last<GivePattern>()[0].pattern, HandlePattern::edge);
    house.press(KeyRole::down);
    EXPECT_EQ(house.last<GivePattern>()[0].pattern, HandlePattern::focus);
}

TEST(Visit, IN5_ChooseIsFourPressesAwayFromAnywhere) {
    const SceneGraph& graph = scene_graph();
    EXPECT_GT(graph.visits.size(), 2000U);
    for (std::size_t i = 0; i < graph.visits.size(); ++i) {
        const VisitScreen screen = open_screen(graph.visits[i]);
        if (screen == VisitScreen::closed) continue;  // closed to visitors
        ASSERT_GE(graph.presses_to_choose[i], 0) << graph.names[i];
        ASSERT_LE(graph.presses_to_choose[i], 4) << graph.names[i];
    }
}

TEST(Visit, IN5_EveryKeyIsAnsweredAtOnceEverywhere) {
    EXPECT_EQ(scene_graph().unanswered, std::vector<std::string>{});
    RecordProperty("states", static_cast<int>(scene_graph().visits.size()));
    RecordProperty("steps", static_cast<int>(scene_graph().steps));
}

TEST(Visit, IN6_HelpNamesEachKeyAndLeavesAfterTwo) {
    FakeHouse house;
    to_picture(house);
    const std::vector<Standing> path = house.visit.visitor.path;
    house.press(KeyRole::help);
    EXPECT_EQ(house.open(), VisitScreen::help);
    const std::vector<std::pair<KeyRole, std::string>> names{
        {KeyRole::up, "Up."},         {KeyRole::down, "Down."},     {KeyRole::back, "Back."},
        {KeyRole::repeat, "Repeat."}, {KeyRole::select, "Select."}, {KeyRole::louder, "Louder."},
        {KeyRole::softer, "Softer."}, {KeyRole::help, "Help."}};
    for (const auto& [role, name] : names) {
        house.press(role);
        EXPECT_TRUE(house.last_said().starts_with(name)) << house.last_said();
        EXPECT_GT(house.last_said().size(), name.size() + 8) << "and its use";
        EXPECT_EQ(house.open(), VisitScreen::help);
    }
    house.press(KeyRole::back);
    EXPECT_EQ(house.last_said(), "Back. Leaves this screen. Press it again to leave.");
    EXPECT_EQ(house.open(), VisitScreen::help) << "once does not leave";
    house.wait(20.0);
    house.press(KeyRole::back);
    EXPECT_EQ(house.open(), VisitScreen::picture);
    EXPECT_EQ(house.visit.visitor.path, path) << "trying keys changed nothing";
}

TEST(Visit, HelpSaysAndShowsTheKeys) {
    FakeHouse house;
    to_choose(house);
    house.press(KeyRole::help);
    EXPECT_TRUE(house.has_said("Up, Down, Back, Repeat, Select and Help.", 0));
    ASSERT_EQ(house.screen().items.size(), key_role_count);
    EXPECT_EQ(house.screen().items[0].name, "Up");
    EXPECT_EQ(house.screen().items[0].value, "Goes to the item before.");
    EXPECT_FALSE(house.screen().focus) << "none of them can be chosen";
}

TEST(Visit, StaffAreTwoPressesAwayFromEveryScreen) {
    FakeHouse house;
    std::set<VisitScreen> from;
    for (const Visit& scene : scenes_of_all_screens()) {
        if (!is_visit_on(scene)) continue;
        Visit visit = scene;
        visit.site.is_staff_called = false;
        visit.visitor.last_key.reset();
        from.insert(open_screen(visit));
        const auto press = [&] {
            VisitStep next = step(visit, KeyPressed{KeyRole::help}, house.world());
            visit = std::move(next.visit);
            return next.orders;
        };
        (void)press();
        EXPECT_FALSE(visit.site.is_staff_called);
        const VisitOrders orders = press();
        EXPECT_TRUE(visit.site.is_staff_called) << static_cast<int>(from.size());
        EXPECT_TRUE(std::ranges::any_of(orders, [](const VisitOrder& order) {
            const auto* const said = std::get_if<Utterance>(&order);
            return said != nullptr && said->text.starts_with("The staff have been called.");
        }));
    }
    EXPECT_GE(from.size(), visit_screen_count - 3) << "all but those where nobody is";
}

TEST(Visit, HelpTwiceIsTwiceOnlyAtOnceAndOnlyWhereThereAreStaff) {
    FakeHouse late;
    to_choose(late);
    ASSERT_TRUE(late.choose("Gallery"));
    late.wait(91.0);
    late.press(KeyRole::help);  // answers the question
    late.wait(6.0);
    late.press(KeyRole::help);
    EXPECT_EQ(late.open(), VisitScreen::help);
    EXPECT_FALSE(late.visit.site.is_staff_called);
    VisitRules rules;
    rules.offers_staff = false;
    FakeHouse alone(rules);
    to_choose(alone);
    alone.press({KeyRole::help, KeyRole::help});
    EXPECT_EQ(alone.last_said(), "Help. Explains the keys.");
    EXPECT_TRUE(alone.last<CallStaff>().empty());
}

TEST(Visit, TheFirstLineIsThreePressesAway) {
    FakeHouse house;
    house.press({KeyRole::select, KeyRole::select, KeyRole::select});
    house.wait(house.load_s + 0.1);
    EXPECT_EQ(house.open(), VisitScreen::practice);
    EXPECT_TRUE(house.visit.visitor.feel.is_force_wanted);
    EXPECT_GT(house.visit.visitor.felt->facts.outline_count, 0);
}

TEST(Visit, IN7_TheHandleMayBeLetGoAtAnyTime) {
    FakeHouse house;
    to_picture(house);
    ASSERT_TRUE(house.choose("Explore freely"));
    house.wait(85.0);  // no handle, no key
    EXPECT_EQ(house.open(), VisitScreen::explore);
    house.wait(20.0);
    EXPECT_EQ(house.open(), VisitScreen::question);
    house.press(KeyRole::up);
    EXPECT_EQ(house.open(), VisitScreen::explore);
    EXPECT_TRUE(house.visit.visitor.felt) << "nothing is lost";
}

TEST(Visit, LongListsComeInTens) {
    FakeHouse house;
    to_choose(house);
    std::vector<std::string> names;
    for (int i = 1; i <= 23; ++i) names.push_back("file " + std::to_string(i));
    house.apply(StickCame{names, {}});
    ASSERT_TRUE(house.choose("Your USB stick"));
    EXPECT_EQ(house.screen().items.size(), 13U) << "next ten, first letter, back";
    ASSERT_TRUE(house.choose("The next ten"));
    EXPECT_EQ(house.screen().items[0].name, "file 11");
    EXPECT_NE(house.last_said().find("Page 2 of 3"), std::string::npos);
    ASSERT_TRUE(house.choose("The next ten"));
    EXPECT_EQ(house.screen().items[2].name, "file 23");
    EXPECT_FALSE(house.find("The next ten"));
    ASSERT_TRUE(house.choose("The ten before"));
    ASSERT_TRUE(house.choose("file 12"));
    EXPECT_EQ(house.visit.visitor.loading->order.index, 11U);
}

TEST(Visit, APictureIsOrderedByTheNameThatTheListSays) {
    FakeHouse house;
    to_choose(house);
    house.apply(StickCame{{"IMG_4512.heic", "IMG_4512.jpg"}, {}});
    ASSERT_TRUE(house.choose("Your USB stick"));
    ASSERT_TRUE(house.choose("photo 45 12, J P G"));
    EXPECT_EQ(house.visit.visitor.loading->order.form, (NameForm{NameDetail::with_ending}));
}

/// Names as a camera gives them, a person's names, and dates.
std::vector<std::string> a_thousand_names() {
    std::vector<std::string> names;
    for (int i = 0; i < 900; ++i) names.push_back("IMG_" + std::to_string(1000 + i) + ".JPG");
    for (int i = 0; i < 60; ++i) names.push_back("boat " + std::to_string(100 + i) + ".png");
    for (int i = 0; i < 30; ++i) names.push_back("2023040" + std::to_string(1 + i % 9) + ".png");
    for (int i = 0; i < 10; ++i) names.push_back("Zebra " + std::to_string(i) + ".png");
    return names;
}

TEST(Visit, AThousandFilesAreFoundByTheirLetters) {
    FakeHouse house;
    to_choose(house);
    house.apply(StickCame{a_thousand_names(), {}});
    ASSERT_TRUE(house.choose("Your USB stick"));
    EXPECT_TRUE(house.has_said("Page 1 of 100", 0));
    ASSERT_TRUE(house.choose("By the first letter"));
    EXPECT_EQ(house.open(), VisitScreen::letters);
    EXPECT_EQ(house.last_said(), "How names begin. digits, 30 files, 1 of 5");
    house.press(KeyRole::down);
    EXPECT_EQ(house.last_said(), "B, 60 files, 2 of 5");
    house.press(KeyRole::down);
    EXPECT_EQ(house.last_said(), "I, 900 files, 3 of 5");
    house.press({KeyRole::up, KeyRole::select});
    EXPECT_EQ(house.open(), VisitScreen::stick);
    EXPECT_EQ(house.last_said(),
              "Your USB stick. Beginning with B: 60 files. Page 1 of 6. boat 100, 1 of 14");
    ASSERT_TRUE(house.choose("The next ten"));
    ASSERT_TRUE(house.choose("boat 112"));
    EXPECT_EQ(house.visit.visitor.loading->order.index, 912U);
    house.wait(house.load_s + 0.1);
    ASSERT_TRUE(house.choose("Another picture"));
    EXPECT_EQ(house.screen().items[*house.screen().focus].name, "boat 112") << "where it was";
    ASSERT_TRUE(house.choose("All files"));
    EXPECT_TRUE(house.has_said("Page 1 of 100", house.transcript.size() - 1));
}

/// Names that a camera gives: the list asks for more letters until ten are left.
TEST(Visit, ACamerasThousandNeedsFewPresses) {
    FakeHouse house;
    to_choose(house);
    house.apply(StickCame{a_thousand_names(), {}});
    ASSERT_TRUE(house.choose("Your USB stick"));
    ASSERT_TRUE(house.choose("By the first letter"));
    ASSERT_TRUE(house.choose("I"));
    ASSERT_TRUE(house.choose("By the next letter"));
    EXPECT_EQ(house.last_said(), "How names begin. I M G 10, 100 files, 1 of 10");
    ASSERT_TRUE(house.choose("I M G 15"));
    ASSERT_TRUE(house.choose("By the next letter"));
    ASSERT_TRUE(house.choose("I M G 153"));
    EXPECT_FALSE(house.find("By the next letter")) << "ten are a page";
    ASSERT_TRUE(house.choose("photo 15 37"));
    EXPECT_EQ(house.visit.visitor.loading->order.index, 537U);
}

TEST(Visit, WhatTheListLeavesOutIsHeardInTheVisitorsLanguage) {
    FakeHouse house;
    to_choose(house);
    house.apply(StickCame{{"a.png"}, StickRest{200, true, false, false}});
    ASSERT_TRUE(house.choose("Your USB stick"));
    EXPECT_TRUE(house.has_said("The list has 1 files of 201.", 0));
    EXPECT_TRUE(house.has_said("Folders within eight others were left out.", 0));
    house.visit.visitor.sound.language = 1;
    EXPECT_NE(house.screen().text.find("Ordner in acht anderen"), std::string::npos);
}

TEST(Visit, LettersOfAStickThatGoesAreLeft) {
    FakeHouse house;
    to_choose(house);
    house.apply(StickCame{a_thousand_names(), {}});
    ASSERT_TRUE(house.choose("Your USB stick"));
    ASSERT_TRUE(house.choose("By the first letter"));
    house.apply(StickGone{});
    EXPECT_EQ(house.open(), VisitScreen::stick);
    EXPECT_FALSE(house.visit.visitor.letters);
    house.apply(StickCame{{"a.png"}, {}});
    EXPECT_EQ(house.screen().items.size(), 2U);
}

TEST(Visit, TheEasiestPicturesComeFirst) {
    FakeHouse house;
    to_choose(house);
    ASSERT_TRUE(house.choose("Gallery"));
    EXPECT_EQ(house.screen().items[0].value, "very easy");
    EXPECT_EQ(house.screen().items[0].name, "Picture 5 en");
    house.press(KeyRole::select);
    EXPECT_EQ(house.last<LoadPicture>()[0].index, 4U);
    EXPECT_EQ(house.last<LoadPicture>()[0].source, PictureSource::gallery);
}

TEST(VisitMenu, EveryScreenHasOneRow) {
    std::multiset<VisitScreen> rows;
    for (const VisitMenu& menu : {main_menu(), picture_menu(), settings_menu(), stick_menu()})
        for (const VisitScreenRow& row : menu.screens) rows.insert(row.screen);
    EXPECT_EQ(rows.size(), visit_screen_count);
    for (std::size_t i = 0; i < visit_screen_count; ++i) {
        const auto screen = static_cast<VisitScreen>(i);
        EXPECT_EQ(rows.count(screen), 1U) << i;
        EXPECT_EQ(row_of(screen).screen, screen);
    }
}

TEST(VisitMenu, EverySettingKeepsEachOfItsValues) {
    FakeHouse house;
    to_picture(house);
    const VisitWorld world = house.world();
    VisitWork work{house.visit.site, house.visit.visitor, world, {}};
    std::size_t count = 0;
    for (const VisitMenu& menu : {picture_menu(), settings_menu()}) {
        for (const VisitItemRow& row : menu.items) {
            const auto* const setting = std::get_if<VisitSetting>(&row.does);
            if (setting == nullptr) continue;
            ++count;
            EXPECT_EQ(&setting_row(row.item), &row) << row.name;
            const auto names = setting->names(world, language_of(work));
            EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size()) << row.name;
            for (std::size_t value = 0; value < names.size(); ++value) {
                setting->value.choose(work, value);
                EXPECT_EQ(setting->value.chosen(work.visitor), value) << row.name;
            }
        }
    }
    EXPECT_GE(count, 10U);
}

}  // namespace
}  // namespace touchline
