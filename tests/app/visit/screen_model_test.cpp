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

TEST(ScreenModel, ALongListHasPagesOfTen) {
    const ListPage last = page_of(23, 40);
    EXPECT_EQ(last.first, 20U);
    EXPECT_EQ(last.end, 23U);
    EXPECT_EQ(last.number, 3);
    EXPECT_EQ(last.count, 3);
    EXPECT_EQ(page_of(20, 10).end, 20U);
    EXPECT_EQ(page_of(20, 10).count, 2);
    EXPECT_EQ(page_of(0, 10).first, page_of(0, 10).end);
    EXPECT_EQ(page_of(0, 10).count, 1);
}

}  // namespace
}  // namespace touchline
