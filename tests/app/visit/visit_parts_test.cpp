// Tests when the parts of a picture are named, and the way to them.
#include "tests/app/visit/fake_world.h"
#include "tests/app/visit/visit_scenes.h"

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(Visit, APartIsReachedAndSaid) {
    FakeHouse house;
    to_picture(house);
    ASSERT_TRUE(house.choose("Parts"));
    EXPECT_NE(house.last_said().find("Body en, middle, 1 of 2"), std::string::npos);
    ASSERT_TRUE(house.choose("Tail en"));
    EXPECT_TRUE(house.last_said().starts_with("The handle will guide you to this part: Tail en."));
    house.wait(2.1);
    ASSERT_TRUE(house.is_leading);
    EXPECT_EQ(house.visit.visitor.leading->guide.kind, GuideKind::to_place);
    EXPECT_EQ(house.visit.visitor.leading->guide.place_W, (Position{0.04, -0.02}));
    house.wait(2.1);
    EXPECT_TRUE(house.has_said("You are there.", 0));
    EXPECT_FALSE(house.visit.visitor.leading);
}

TEST(Visit, TheOnlyPartIsNotCounted) {
    FakeHouse house;
    to_picture(house);
    PictureFacts facts = house.visit.visitor.felt->facts;
    facts.parts.resize(1);
    house.apply(PictureReady{house.visit.visitor.felt->order.request, facts});
    ASSERT_TRUE(house.find("Parts"));
    EXPECT_TRUE(house.last_said().starts_with("Parts, 2 of ")) << house.last_said();
    house.press(KeyRole::select);
    EXPECT_TRUE(house.last_said().ends_with(" Body en, middle")) << house.last_said();
}

TEST(Visit, PartsAreNamedWhereTheHandRestsAndNotWhileItIsQuick) {
    FakeHouse house;
    to_picture(house);
    ASSERT_TRUE(house.choose("Explore freely"));
    house.wait(2.0);
    const std::size_t before = house.transcript.size();
    HandleSeen quick;
    quick.part = 0;
    quick.has_moved = true;
    quick.speed_m_per_s = 0.2;
    for (int i = 0; i < 10; ++i) {
        house.apply(quick);
        house.wait(0.1);
    }
    EXPECT_EQ(house.transcript.size(), before);
    HandleSeen still = quick;
    still.speed_m_per_s = 0.01;
    house.apply(still);
    EXPECT_EQ(house.last_said(), "Body en");
    const std::size_t named = house.transcript.size();
    house.wait(5.0);
    EXPECT_EQ(house.transcript.size(), named) << "once";
    still.part = 1;
    house.apply(still);
    house.wait(0.3);
    EXPECT_EQ(house.transcript.size(), named) << "it has to rest";
    house.wait(0.2);
    EXPECT_EQ(house.last_said(), "Tail en");
    ASSERT_TRUE(house.choose("Where am I?"));
    EXPECT_EQ(house.last_said(), "On: Tail en. In the picture: middle.");
}

TEST(Visit, ExploringSaysANameThatWasSaidBefore) {
    FakeHouse house;
    to_picture(house);
    HandleSeen on_part;
    on_part.part = 0;
    on_part.has_moved = true;
    house.apply(on_part);
    house.wait(1.0);
    ASSERT_EQ(house.last_said(), "Body en");
    ASSERT_TRUE(house.choose("Explore freely"));
    const std::size_t before = house.transcript.size();
    house.apply(on_part);
    EXPECT_EQ(house.last_said(), "Body en");
    house.apply(on_part);
    house.wait(1.0);
    EXPECT_EQ(house.transcript.size(), before + 1) << "once";
}

TEST(Visit, NoPartIsNamedUnderAHandThatHasNotMovedOnThePicture) {
    FakeHouse house;
    to_picture(house);
    HandleSeen resting;
    resting.part = 0;
    house.apply(resting);
    house.wait(1.0);
    EXPECT_FALSE(house.has_said("Body en", 0));
    resting.has_moved = true;
    house.apply(resting);
    EXPECT_EQ(house.last_said(), "Body en");
    ASSERT_TRUE(house.choose("Next picture"));
    house.wait(0.5);
    const std::size_t before = house.transcript.size();
    resting.has_moved = false;
    house.apply(resting);
    house.wait(1.0);
    EXPECT_FALSE(house.has_said("Body en", before));
}

}  // namespace
}  // namespace touchline
