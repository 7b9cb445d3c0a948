// Keys, lists and ways: IN of the requirements, over every state that can be reached.
#include "tests/app/session/fake_world.h"
#include "tests/app/session/visit_scenes.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(Visit, IN1_SixRolesReachEveryScreenThatKeysCanReach) {
    // The graph is followed by KeyRole alone; volume keys lead nowhere.
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
        const Visit& visit = scene_graph().visits[i];
        if (!is_visit_on(visit) || visit.visitor.over || visit.visitor.leading) continue;
        const auto after = [&](KeyRole role) {
            return step(visit, KeyPressed{role}, house.world()).visit;
        };
        // Up, Down and Next never leave a screen.
        for (const KeyRole role : {KeyRole::up, KeyRole::down, KeyRole::next}) {
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
    // A press has no length and no end, and nothing else is told of a key: the same presses lead to
    // the same place however long each takes.
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
        if (screen == VisitScreen::closed) continue;  // nobody may come in
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
        {KeyRole::next, "Next."},     {KeyRole::select, "Select."}, {KeyRole::louder, "Louder."},
        {KeyRole::softer, "Softer."}, {KeyRole::help, "Help."}};
    for (const auto& [role, name] : names) {
        house.press(role);
        EXPECT_TRUE(house.last_said().starts_with(name)) << house.last_said();
        EXPECT_GT(house.last_said().size(), name.size() + 8) << "and its use";
        EXPECT_EQ(house.open(), VisitScreen::help);
    }
    house.press(KeyRole::down);
    house.press(KeyRole::help);
    EXPECT_EQ(house.open(), VisitScreen::help) << "once does not leave";
    house.press(KeyRole::help);
    EXPECT_EQ(house.open(), VisitScreen::picture);
    EXPECT_EQ(house.visit.visitor.path, path) << "trying keys changed nothing";
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
    house.happen(StickCame{names, ""});
    ASSERT_TRUE(house.choose("Your USB stick"));
    EXPECT_EQ(house.screen().items.size(), 12U);
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

TEST(Visit, TheEasiestPicturesComeFirst) {
    FakeHouse house;
    to_choose(house);
    ASSERT_TRUE(house.choose("Pictures of the house"));
    EXPECT_EQ(house.screen().items[0].value, "very easy");
    EXPECT_EQ(house.screen().items[0].name, "Picture 5 en");
    house.press(KeyRole::select);
    EXPECT_EQ(house.last<LoadPicture>()[0].index, 4U);
    EXPECT_EQ(house.last<LoadPicture>()[0].source, PictureSource::gallery);
}

}  // namespace
}  // namespace touchline
