// Tests what a visitor hears when the handle loses its force, and while it has none.
#include "app/visit/told_lines.h"
#include "tests/app/visit/fake_world.h"
#include "tests/app/visit/visit_scenes.h"

#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// How often `part` is in the text.
std::size_t count_of(const std::string& part, const std::string& text) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

TEST(Visit, ForceThatIsLostSaysThatGuidingStoppedAndNamesTheStaffOnce) {
    FakeHouse house;
    to_picture(house);
    house.lead_s = 100.0;
    ASSERT_TRUE(house.choose("Guide me along the largest outline"));
    house.wait(3.0);
    house.apply(TroubleBegan{TroubleKind::device, spoken_fault(Fault::device_lost, Language())});
    EXPECT_EQ(house.last_said(),
              "The handle. Guiding has stopped. The force is off. The handle does not answer. "
              "Press Down to call staff, or Select to go on without force.");
}

/// In every language and of every fault, so that the sentence that is left out is the same text.
TEST(Visit, NoTroubleOfTheHandleNamesTheStaffTwice) {
    for (std::size_t at = 0; at < all_languages().size(); ++at) {
        const Language& language = all_languages()[at];
        std::vector<std::string> sentences{""};
        for (std::size_t i = 1; i < fault_count; ++i)
            sentences.push_back(spoken_fault(static_cast<Fault>(i), language));
        for (const LineRow& row : device_lines())
            sentences.push_back(language.text("trouble", std::string(row.told)));
        for (const std::string& sentence : sentences) {
            VisitRules rules;
            rules.sound.language = at;
            FakeHouse house(rules);
            house.press({KeyRole::select, KeyRole::select});
            house.apply(TroubleBegan{TroubleKind::device, sentence});
            const std::string staff = at == 1 ? "Personal" : at == 0 ? "staff" : "person";
            EXPECT_LE(count_of(staff, house.last_said()), 1U) << house.last_said();
            EXPECT_FALSE(house.screen().text.empty());
        }
    }
}

TEST(Visit, WithoutForceWhatNeedsItSaysSo) {
    FakeHouse house;
    to_picture(house);
    house.apply(TroubleBegan{TroubleKind::device, ""});
    house.press(KeyRole::select);
    EXPECT_TRUE(house.last_said().starts_with(
        "Thing 4 en. Guide me along the largest outline, no force now, 1 of"))
        << house.last_said();
    const std::string why = "The handle has no force now. Move it yourself.";
    for (const char* name : {"Guide me along the largest outline", "Bring me back to a line"}) {
        ASSERT_TRUE(house.find(name));
        EXPECT_TRUE(house.last_said().find(", no force now, ") != std::string::npos);
        house.press(KeyRole::select);
        EXPECT_EQ(house.last_said(), why);
        EXPECT_FALSE(house.visit.visitor.leading);
    }
    ASSERT_TRUE(house.choose("Parts"));
    EXPECT_TRUE(house.last_said().starts_with("Parts. " + why)) << house.last_said();
    house.press(KeyRole::select);
    EXPECT_EQ(house.last_said(), why);
    house.apply(TroubleEnded{TroubleKind::device});
    EXPECT_NE(house.screen().text, why);
    house.press(KeyRole::back);
    ASSERT_TRUE(house.find("Guide me along the largest outline"));
    EXPECT_EQ(house.last_said().find("no force"), std::string::npos);
}

}  // namespace
}  // namespace touchline
