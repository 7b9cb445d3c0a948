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
                                    KeyRole::select, KeyRole::down,   KeyRole::select,
                                    KeyRole::select};
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
        // Help lies over another screen, and two presses of Back leave it.
        const int most = screen == VisitScreen::help ? 4 + 2 : 4;
        ASSERT_LE(graph.presses_to_choose[i], most) << graph.names[i];
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
    EXPECT_EQ(house.last_said(), "Back. Leaves a screen. Press it again to leave the help.");
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
    EXPECT_TRUE(
        house.has_said("Six keys do everything: Up, Down, Back, Repeat, Select and Help. "
                       "Two more, if there are any, change the volume.",
                       0));
    ASSERT_EQ(house.screen().items.size(), key_role_count);
    EXPECT_EQ(house.screen().items[0].name, "Up");
    EXPECT_EQ(house.screen().items[0].value, "Goes to the previous item. Hold it to skip several.");
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
        EXPECT_TRUE(visit.visitor.caption.text.starts_with("The staff have been called."));
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

TEST(Visit, APictureIsOrderedByTheNameThatTheListSays) {
    FakeHouse house;
    to_choose(house);
    house.apply(StickCame{{"IMG_4512.heic", "IMG_4512.jpg"}, {}});
    ASSERT_TRUE(house.choose("Your USB stick"));
    ASSERT_TRUE(house.choose("photo 45 12, J P G"));
    EXPECT_EQ(house.visit.visitor.loading->order.form, (NameForm{NameDetail::with_ending}));
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

TEST(VisitMenu, EveryScreenHasOneRow) {
    std::multiset<VisitScreen> rows;
    for (const VisitMenu& menu : {main_menu(), picture_menu(), settings_menu(), list_menu()})
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
