// Tests a shape in the hand, as a visitor chooses and turns it.
#include "tests/app/visit/visit_scenes.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double key_rad = std::numbers::pi / 12.0;

void to_bar(FakeHouse& house) {
    to_picture(house);
    ASSERT_TRUE(house.choose("Shape in the hand"));
    ASSERT_TRUE(house.choose("a bar"));
    ASSERT_EQ(house.open(), VisitScreen::picture);
}

TEST(VisitShape, IsThereOnlyWhereTheHouseOffersIt) {
    EXPECT_FALSE(Settings{}.offers_shapes);
    FakeHouse house;
    house.settings.offers_shapes = false;
    to_picture(house);
    EXPECT_FALSE(has_item(house, VisitItem::held_shape));
    house.settings.offers_shapes = true;
    EXPECT_TRUE(has_item(house, VisitItem::held_shape));
}

TEST(VisitShape, IsTakenSaidAndOrdered) {
    FakeHouse house;
    to_picture(house);
    EXPECT_FALSE(has_item(house, VisitItem::turn_left));
    ASSERT_TRUE(house.choose("Shape in the hand"));
    const std::size_t before = house.transcript.size();
    ASSERT_TRUE(house.choose("a key"));
    EXPECT_TRUE(house.has_said("a key", before));
    ASSERT_FALSE(house.last<Feel>().empty());
    EXPECT_EQ(house.last<Feel>().back().shape, HeldShape::key);
    EXPECT_TRUE(has_item(house, VisitItem::turn_left));
}

TEST(VisitShape, EachSelectTurnsItByAStepAndSaysHowFar) {
    FakeHouse house;
    to_bar(house);
    ASSERT_TRUE(house.choose("Turn it left"));
    EXPECT_EQ(house.last_said(), "turned left by 15 degrees");
    house.press(KeyRole::select);
    EXPECT_EQ(house.last_said(), "turned left by 30 degrees");
    EXPECT_NEAR(house.last<Feel>().back().turn_rad, 2.0 * key_rad, 1e-12);
    ASSERT_TRUE(house.find("Turn it right"));
    for (int i = 0; i < 3; ++i) house.press(KeyRole::select);
    EXPECT_EQ(house.last_said(), "turned right by 15 degrees");
    ASSERT_TRUE(house.choose("Turn it back"));
    EXPECT_EQ(house.last_said(), "not turned");
    EXPECT_EQ(house.last<Feel>().back().turn_rad, 0.0);
}

TEST(VisitShape, AKnobTurnsItWithoutAWordAndAKeyGoesToTheNextStep) {
    FakeHouse house;
    to_bar(house);
    const std::size_t before = house.transcript.size();
    house.apply(KnobTurned{0.1});
    EXPECT_EQ(house.transcript.size(), before);
    EXPECT_NEAR(house.last<Feel>().back().turn_rad, 0.1, 1e-12);
    house.apply(KnobTurned{std::numeric_limits<double>::quiet_NaN()});
    EXPECT_NEAR(house.visit.visitor.feel.turn_rad, 0.1, 1e-12);
    ASSERT_TRUE(house.choose("Turn it left"));
    EXPECT_NEAR(house.visit.visitor.feel.turn_rad, key_rad, 1e-12);
}

TEST(VisitShape, OneDegreeIsSingular) {
    FakeHouse house;
    to_bar(house);
    for (const double by_rad : {0.0175, -0.035}) {
        house.apply(KnobTurned{by_rad});
        ASSERT_TRUE(house.find("Turn it left"));
        EXPECT_EQ(house.screen().items[*house.screen().focus].value,
                  by_rad > 0.0 ? "turned left by 1 degree" : "turned right by 1 degree");
    }
}

TEST(VisitShape, AKnobAloneTurnsNothingAndKeepsNoVisit) {
    FakeHouse house;
    to_picture(house);
    house.wait(10.0);
    const double active_s = house.visit.visitor.active_s;
    house.apply(KnobTurned{0.5});
    EXPECT_EQ(house.visit.visitor.feel.turn_rad, 0.0);
    EXPECT_EQ(house.visit.visitor.active_s, active_s);
    FakeHouse other;
    to_bar(other);
    other.wait(10.0);
    other.apply(KnobTurned{0.5});
    EXPECT_EQ(other.visit.visitor.active_s, other.visit.site.now_s);
}

TEST(VisitShape, StaysForTheNextPictureAndGoesWithTheVisitor) {
    FakeHouse house;
    to_bar(house);
    ASSERT_TRUE(house.choose("Another picture"));
    house.press({KeyRole::down, KeyRole::select});
    house.wait(house.load_s + 0.1);
    EXPECT_EQ(house.visit.visitor.feel.shape, HeldShape::bar);
    finish(house);
    EXPECT_EQ(house.visit.visitor.feel.shape, HeldShape::none);
}

TEST(VisitShape, ResetPutsItDownAndSoDoesTheHouse) {
    FakeHouse house;
    to_bar(house);
    house.settings.offers_shapes = false;
    house.wait(0.1);
    EXPECT_EQ(house.visit.visitor.feel.shape, HeldShape::none);
}

}  // namespace
}  // namespace touchline
