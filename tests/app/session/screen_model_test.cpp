#include "app/session/screen_model.h"

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

}  // namespace
}  // namespace touchline
