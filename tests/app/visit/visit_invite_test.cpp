// What is heard while nobody is here.
#include "tests/app/visit/fake_world.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace touchline {
namespace {

VisitRules inviting() {
    VisitRules rules;
    rules.invites = true;
    return rules;
}

TEST(Invitation, IsHeardWithinTwelveSecondsAndInEveryLanguageInTurn) {
    FakeHouse house(inviting());
    house.wait(12.0);
    ASSERT_FALSE(house.transcript.empty());
    const std::size_t count = house.languages.size();
    house.wait(11.0 * static_cast<double>(count));
    std::set<std::string> languages;
    for (std::size_t i = 0; i < house.transcript.size(); ++i) {
        languages.insert(house.transcript[i].language);
        if (i == 0) continue;
        const double gap_s = house.transcript[i].time_s - house.transcript[i - 1].time_s;
        EXPECT_GT(gap_s, 10.0);
        EXPECT_LT(gap_s, 12.0);
    }
    EXPECT_EQ(languages.size(), count);
    EXPECT_EQ(house.open(), VisitScreen::attract);
}

TEST(Invitation, NamesKeysOnlyWhereThereAreKeys) {
    for (const SwitchUse use : {SwitchUse::move_and_select, SwitchUse::by_itself}) {
        FakeHouse house(inviting());
        house.settings.two_switches = use;
        house.wait(12.0);
        EXPECT_EQ(house.last_said(), "Pictures to feel. Hold the handle, or press a switch.");
        EXPECT_EQ(house.screen().text, "Hold the handle, or press a switch.");
    }
}

TEST(Invitation, IsNotSaidInQuietHoursNorInAVisit) {
    FakeHouse quiet;
    quiet.wait(60.0);
    EXPECT_TRUE(quiet.transcript.empty());
    FakeHouse house(inviting());
    house.press(KeyRole::select);
    const std::size_t said = house.transcript.size();
    house.wait(25.0);
    EXPECT_FALSE(house.has_said("Hold the handle, or press any key.", said));
}

}  // namespace
}  // namespace touchline
