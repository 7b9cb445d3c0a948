// Tests that two switches, or one, reach all of a screen (accessibility IN-9).
#include "app/visit/keys/two_switches.h"

#include <set>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// A list that handles roles as every screen does.
struct List {
    SpokenScreen screen;
    std::vector<KeyRole> pressed;

    explicit List(std::size_t items) {
        screen.title = "List";
        for (std::size_t i = 0; i < items; ++i)
            screen.items.push_back({static_cast<int>(i), ItemRole::choice, "Item", "", ""});
        if (items > 0) screen.focus = 0;
    }

    void take(KeyRole role) {
        pressed.push_back(role);
        if (role == KeyRole::down || role == KeyRole::up)
            if (const auto move = move_focus(screen, role == KeyRole::down))
                screen.focus = move->focus;
    }
};

SwitchStep act(List& list, SwitchScan& scan, SwitchEvent event, double scan_s = 0.0,
               double now_s = 0.0) {
    const SwitchStep step = step_switches(scan, event, list.screen, scan_s, now_s, Language());
    scan = step.scan;
    if (step.press) list.take(*step.press);
    return step;
}

TEST(TwoSwitches, WalkItemsThenRolesThenItemsAgain) {
    List list(3);
    SwitchScan scan;
    std::vector<std::string> heard;
    for (int i = 0; i < 6; ++i) {
        const SwitchStep step = act(list, scan, SwitchEvent::move);
        heard.push_back(step.said.empty() ? std::to_string(*list.screen.focus) : step.said);
    }
    EXPECT_EQ(heard, (std::vector<std::string>{"1", "2", "Repeat", "Back", "Help", "0"}));
}

TEST(TwoSwitches, SelectTakesWhatIsUnderIt) {
    List list(2);
    SwitchScan scan;
    EXPECT_EQ(act(list, scan, SwitchEvent::select).press, KeyRole::select);
    EXPECT_EQ(act(list, scan, SwitchEvent::select).press, KeyRole::select) << "once more";
    (void)act(list, scan, SwitchEvent::move);
    int moves = 0;
    for (const KeyRole role : {KeyRole::repeat, KeyRole::back, KeyRole::help}) {
        ++moves;
        for (int i = 0; i < moves; ++i) (void)act(list, scan, SwitchEvent::move);
        EXPECT_EQ(act(list, scan, SwitchEvent::select).press, role);
    }
}

/// Repeat says the item again, so the item is what Select takes then.
TEST(TwoSwitches, AfterAKeySelectTakesTheItemThatIsHeard) {
    List list(2);
    SwitchScan scan;
    for (int i = 0; i < 2; ++i) (void)act(list, scan, SwitchEvent::move);
    EXPECT_EQ(act(list, scan, SwitchEvent::select).press, KeyRole::repeat);
    EXPECT_EQ(act(list, scan, SwitchEvent::select).press, KeyRole::select);
    EXPECT_EQ(list.screen.focus, 1U);
    EXPECT_EQ(act(list, scan, SwitchEvent::move).said, "Repeat") << "once more is one move away";
}

TEST(TwoSwitches, OneBackIsEnough) {
    List list(2);
    list.screen.items.back().name = "Back";
    SwitchScan scan;
    std::vector<std::string> heard;
    for (int i = 0; i < 4; ++i) {
        const SwitchStep step = act(list, scan, SwitchEvent::move);
        heard.push_back(step.said.empty() ? std::to_string(*list.screen.focus) : step.said);
    }
    EXPECT_EQ(heard, (std::vector<std::string>{"1", "Repeat", "Help", "0"}));
}

TEST(TwoSwitches, AnotherScreenIsWalkedFromItsItems) {
    List list(2);
    SwitchScan scan;
    for (int i = 0; i < 3; ++i) (void)act(list, scan, SwitchEvent::move);
    EXPECT_EQ(act(list, scan, SwitchEvent::select).press, KeyRole::back);
    for (int i = 0; i < 2; ++i) (void)act(list, scan, SwitchEvent::move);
    list.screen.title = "The screen before";
    EXPECT_EQ(act(list, scan, SwitchEvent::select).press, KeyRole::select);
}

TEST(TwoSwitches, AScreenWithoutItemsHasTheRoles) {
    List list(0);
    SwitchScan scan;
    std::set<KeyRole> pressed;
    for (int i = 0; i < 4; ++i) {
        (void)act(list, scan, SwitchEvent::move);
        pressed.insert(*act(list, scan, SwitchEvent::select).press);
    }
    EXPECT_EQ(pressed, (std::set<KeyRole>{KeyRole::repeat, KeyRole::back, KeyRole::help}));
}

TEST(TwoSwitches, ByItselfItMovesAtItsPaceAndStopsAfterTwoRounds) {
    List list(2);
    SwitchScan scan;
    int moves = 0;
    for (int i = 1; i <= 1000; ++i) {
        const SwitchStep step = act(list, scan, SwitchEvent::tick, 2.0, 0.1 * i);
        moves += step.press || !step.said.empty() ? 1 : 0;
        if (i == 19) {
            EXPECT_EQ(moves, 0);
        }
        if (i == 21) {
            EXPECT_EQ(moves, 1);
        }
    }
    EXPECT_EQ(moves, 2 * (2 + 3)) << "items and roles, twice";
    EXPECT_TRUE(act(list, scan, SwitchEvent::move, 2.0, 200.0).press) << "and goes on if asked";
}

TEST(TwoSwitches, WhereAnyKeyDoesTheSameBothPressOneAndNoneComesByItself) {
    for (const std::size_t items : {std::size_t{0}, std::size_t{3}}) {
        List list(items);
        list.screen.takes_any_key = true;
        SwitchScan scan;
        for (int i = 0; i < 100; ++i) {
            const SwitchStep step = act(list, scan, SwitchEvent::tick, 2.0, 0.1 * i);
            EXPECT_FALSE(step.press);
            EXPECT_EQ(step.said, "");
        }
        EXPECT_EQ(act(list, scan, SwitchEvent::move, 2.0, 10.0).press, KeyRole::select);
        EXPECT_EQ(act(list, scan, SwitchEvent::select, 2.0, 10.1).press, KeyRole::select);
        list.screen.takes_any_key = false;
        EXPECT_FALSE(act(list, scan, SwitchEvent::tick, 2.0, 12.0).press) << "its time begins anew";
    }
}

TEST(TwoSwitches, WithoutAPaceNothingMovesByItself) {
    List list(2);
    SwitchScan scan;
    for (int i = 0; i < 100; ++i)
        EXPECT_FALSE(act(list, scan, SwitchEvent::tick, 0.0, 1.0 * i).press);
}

}  // namespace
}  // namespace touchline
