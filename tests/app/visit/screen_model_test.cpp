#include "app/visit/screen_model.h"

#include <gtest/gtest.h>

namespace touchline {
namespace {

SpokenScreen firmness() {
    SpokenScreen screen;
    screen.title = "How it feels";
    screen.text = "Choose what to change";
    screen.items = {{1, ItemRole::setting, "Firmness", "medium", ""},
                    {2, ItemRole::toggle, "Sounds", "on", ""},
                    {3, ItemRole::choice, "Done", "", ""}};
    screen.focus = 0;
    return screen;
}

TEST(ScreenModel, AnItemIsSaidWithValueRoleAndPlace) {
    const Language english;
    EXPECT_EQ(spoken_item(firmness(), 0, english), "Firmness, medium, setting, 1 of 3");
    EXPECT_EQ(spoken_item(firmness(), 1, english), "Sounds, on, setting, 2 of 3");
    EXPECT_EQ(spoken_item(firmness(), 2, english), "Done, 3 of 3");
}

TEST(ScreenModel, AWholeScreenIsSaidInSentences) {
    EXPECT_EQ(spoken_screen(firmness(), Language()),
              "How it feels. Choose what to change. Firmness, medium, setting, 1 of 3");
}

TEST(ScreenModel, AListGoesRoundItsEnds) {
    SpokenScreen screen = firmness();
    EXPECT_FALSE(move_focus(screen, true)->has_wrapped);
    EXPECT_EQ(move_focus(screen, true)->focus, 1U);
    EXPECT_TRUE(move_focus(screen, false)->has_wrapped);
    EXPECT_EQ(move_focus(screen, false)->focus, 2U);
    screen.focus.reset();
    EXPECT_EQ(move_focus(screen, false)->focus, 2U);
    screen.items.clear();
    EXPECT_FALSE(move_focus(screen, true));
}

TEST(ScreenModel, TheFocusStaysOnAnItem) {
    SpokenScreen screen = firmness();
    set_focus(screen, 7);
    EXPECT_EQ(screen.focus, 2U);
    EXPECT_EQ(place_of(screen.items, 2), 1U);
    EXPECT_FALSE(place_of(screen.items, 4));
    screen.items.clear();
    set_focus(screen, 0);
    EXPECT_FALSE(screen.focus);
}

TEST(ScreenModel, ItemsWithPlacesOfTheirOwnAreCountedWithoutTheWayOut) {
    SpokenScreen list;
    list.title = "Gallery";
    list.items = {{1000, ItemRole::choice, "A star", "easy", "", "picture 37 of 205"},
                  {0, ItemRole::choice, "Back", "", ""}};
    const Language english;
    EXPECT_EQ(spoken_item(list, 0, english), "A star, easy, picture 37 of 205");
    EXPECT_EQ(spoken_item(list, 1, english), "Back");
    EXPECT_EQ(told_place(list, 1, english), "");
}

TEST(ScreenModel, TheOnlyItemIsNotCounted) {
    SpokenScreen screen;
    screen.items = {{0, ItemRole::choice, "Back", "", ""}};
    const Language english;
    EXPECT_EQ(spoken_item(screen, 0, english), "Back");
    screen.items.front().place = "picture 37 of 205";
    EXPECT_EQ(spoken_item(screen, 0, english), "Back, picture 37 of 205");
    screen.items.push_back({1, ItemRole::choice, "Go on", "", ""});
    screen.items.front().place = "";
    EXPECT_EQ(spoken_item(screen, 0, english), "Back") << "its own place is none";
    EXPECT_EQ(spoken_item(screen, 1, english), "Go on") << "nor is it counted beside it";
    EXPECT_EQ(told_place_among(1, 1, english), "");
    EXPECT_EQ(told_place_among(1, 2, english), "1 of 2");
}

TEST(ScreenModel, AJumpGoesAScreenOnAndStopsAtTheEnds) {
    SpokenScreen list;
    list.items.resize(16);
    EXPECT_FALSE(jump_focus(list, true));
    list.focus = 0;
    EXPECT_FALSE(jump_focus(list, false));
    std::vector<std::size_t> places;
    while (const auto to = jump_focus(list, true)) places.push_back(*(list.focus = to));
    EXPECT_EQ(places, (std::vector<std::size_t>{6, 12, 15}));
    EXPECT_EQ(jump_focus(list, false), 9U);
}

}  // namespace
}  // namespace touchline
