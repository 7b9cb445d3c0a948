// Tests the main things of a photograph: looked for, told, opened, kept.
#include "tests/app/visit/fake_world.h"
#include "tests/app/visit/visit_scenes.h"

#include <gtest/gtest.h>

namespace touchline {
namespace {

ThingsLookedFor looked_for(const FakeHouse& house, int things) {
    const ThingSearch search = things > 0 ? ThingSearch::found : ThingSearch::unclear;
    return {house.visit.visitor.felt->order.request, {1, 1, things + 1, things + 1, search}};
}

TEST(Visit, APhotographsMainThingTakesItsPlaceBeforeAHandHasTouchedIt) {
    FakeHouse house;
    to_picture(house);
    const std::uint64_t whole = house.visit.visitor.felt->order.request;
    house.apply(looked_for(house, 2));
    const LoadPicture wanted = house.last<LoadPicture>()[0];
    EXPECT_NE(wanted.request, whole);
    EXPECT_EQ(wanted.view, 1);
    PictureFacts facts = house.visit.visitor.felt->facts;
    facts.place = {1, 1, 1, 3, ThingSearch::found};
    house.apply(PictureReady{wanted.request, facts});
    EXPECT_TRUE(house.has_said("Thing 1 of 2 in the photograph", 0)) << house.last_said();
    EXPECT_EQ(house.open(), VisitScreen::picture);
    ASSERT_TRUE(house.find("How much of the photo"));
    EXPECT_EQ(house.last_said().find("Thing 1"), std::string::npos) << "its screen says that";
    house.press(KeyRole::select);
    EXPECT_TRUE(house.last_said().starts_with(
        "How much of the photo. Now: Thing 1 of 2 in the photograph. The next thing"));
    EXPECT_FALSE(house.find("The previous thing"));
    ASSERT_TRUE(house.choose("The next thing"));
    EXPECT_EQ(house.last<LoadPicture>()[0].view, 2);
}

/// Opens a photograph whose main thing is still being looked for.
PictureFacts shortly_told(FakeHouse& house) {
    to_choose(house);
    EXPECT_TRUE(house.choose("Camera"));
    house.press(KeyRole::select);
    house.apply(CameraCaptured{});
    const LoadPicture photo = house.last<LoadPicture>()[0];
    PictureFacts facts = fake_facts(photo);
    facts.place = {1, 1, 1, 1, ThingSearch::under_way};
    house.apply(PictureReady{photo.request, facts});
    EXPECT_EQ(house.last_said(), facts.title + ". Its main subject is being looked for");
    return facts;
}

/// Expects the rest to be told once, with the item that has the focus; Repeat says it again.
void expect_rest(const FakeHouse& house) {
    const std::string told = house.last_said();
    EXPECT_NE(told.find("From the side"), std::string::npos) << told;
    EXPECT_NE(told.find("5 outlines"), std::string::npos) << told;
    EXPECT_NE(told.find("Guide me along the largest outline, 1 of"), std::string::npos) << told;
    EXPECT_EQ(house.visit.visitor.caption.text, told);
    EXPECT_FALSE(house.visit.visitor.is_told_shortly);
}

/// The result comes in a moment and would cut a long description of the whole.
TEST(Visit, APhotographWhoseMainThingIsLookedForIsToldWithIt) {
    FakeHouse house;
    PictureFacts facts = shortly_told(house);
    house.apply(looked_for(house, 1));
    facts.place = {1, 1, 1, 2, ThingSearch::found};
    house.apply(PictureReady{house.last<LoadPicture>()[0].request, facts});
    ASSERT_EQ(house.last<Utterance>().size(), 1U);
    EXPECT_EQ(house.last<Utterance>()[0].priority, SpeechPriority::hint) << "the first is not cut";
    expect_rest(house);
}

TEST(Visit, APhotographIsToldAllWhateverTheSearchFinds) {
    for (const auto things :
         {ThingSearch::unclear, ThingSearch::absent, ThingSearch::impossible, ThingSearch::found}) {
        FakeHouse house;
        (void)shortly_told(house);
        HandleSeen handle;
        handle.part = 0;
        if (things == ThingSearch::found) house.apply(handle);  // the hand keeps the whole
        ThingsLookedFor looked = looked_for(house, things == ThingSearch::found ? 1 : 0);
        looked.place.things = things;
        house.apply(looked);
        expect_rest(house);
    }
    FakeHouse house;
    (void)shortly_told(house);
    house.apply(looked_for(house, 1));
    house.apply(PictureFailed{house.last<LoadPicture>()[0].request, ""});
    expect_rest(house);
}

/// Otherwise the main thing would be drawn under a screen that lists the parts of the whole.
TEST(Visit, WhoGoesToAnotherScreenKeepsTheWhole) {
    FakeHouse house;
    (void)shortly_told(house);
    house.apply(looked_for(house, 1));
    const std::uint64_t main_thing = house.last<LoadPicture>()[0].request;
    ASSERT_TRUE(house.choose("Explore freely"));
    EXPECT_EQ(house.last<CancelLoad>()[0].request, main_thing);
    EXPECT_EQ(house.open(), VisitScreen::explore);
    house.press(KeyRole::back);
    EXPECT_NE(house.last_said().find("From the side"), std::string::npos) << "not told before";
    EXPECT_TRUE(house.find("How much of the photo"));
}

TEST(Visit, AHandThatHasFoundALineKeepsItAndIsToldOfTheMainThing) {
    FakeHouse house;
    to_picture(house);
    HandleSeen handle;
    handle.part = 0;
    house.apply(handle);
    handle.part.reset();
    house.apply(handle);
    const std::uint64_t whole = house.visit.visitor.felt->order.request;
    house.apply(looked_for(house, 1));
    EXPECT_EQ(house.visit.site.request, whole) << "nothing else is opened";
    EXPECT_EQ(house.last_said(),
              "The main subject was found. You will find it under: How much of the photo.");
    EXPECT_EQ(house.last<Utterance>()[0].priority, SpeechPriority::hint);
    ASSERT_TRUE(house.choose("How much of the photo"));
    ASSERT_TRUE(house.choose("The previous thing"));
    EXPECT_EQ(house.last<LoadPicture>()[0].view, 1);
}

TEST(Visit, WhatAHandTouchesWhileTheMainThingIsOpenedStays) {
    FakeHouse house;
    to_picture(house);
    const std::uint64_t whole = house.visit.visitor.felt->order.request;
    house.apply(looked_for(house, 1));
    const std::uint64_t main_thing = house.last<LoadPicture>()[0].request;
    HandleSeen handle;
    handle.part = 0;
    house.apply(handle);
    EXPECT_EQ(house.last<CancelLoad>()[0].request, main_thing);
    EXPECT_EQ(house.visit.visitor.felt->order.request, whole);
    EXPECT_EQ(house.visit.visitor.felt->order.view, 2) << "another detail is of the whole";
    EXPECT_EQ(house.last_said(),
              "The main subject was found. You will find it under: How much of the photo.");
}

TEST(Visit, WhoHasEnlargedAPlaceKeepsIt) {
    FakeHouse house;
    to_picture(house);
    ASSERT_TRUE(house.choose("Enlargement"));
    ASSERT_TRUE(house.choose("Tail en"));
    house.wait(0.5);
    const std::uint64_t enlarged = house.visit.visitor.felt->order.request;
    house.apply(looked_for(house, 1));
    EXPECT_EQ(house.visit.site.request, enlarged);
}

TEST(Visit, WhereNothingIsClearAPhotographStaysAndThatIsTold) {
    FakeHouse house;
    to_picture(house);
    house.apply(looked_for(house, 0));
    EXPECT_EQ(house.last_said(), "No clear main subject was found.");
    EXPECT_FALSE(house.find("How much of the photo"));
    EXPECT_FALSE(house.find("Pages"));
    ThingsLookedFor old = looked_for(house, 1);
    old.request += 7;
    house.apply(old);
    EXPECT_EQ(house.visit.visitor.felt->facts.place.things, ThingSearch::unclear);
}

TEST(Visit, WhatAPhotographIsTakenForIsToldAsAGuess) {
    const NamedThing dog{ThingName::dog, {0.0, 0.4, 0.3, 0.7}, 0.9};
    FakeHouse house;
    to_picture(house);
    ThingsLookedFor looked = looked_for(house, 0);
    looked.names = {dog};
    house.apply(looked);
    EXPECT_EQ(house.last_said(), "Probably a dog, on the left. No clear main subject was found.");
    ASSERT_TRUE(house.choose("Tell me again"));
    const std::string told = house.last_said();
    EXPECT_LT(told.find("From the side"), told.find("Probably a dog, on the left."))
        << "what somebody wrote goes before a guess: " << told;
}

TEST(Visit, WithoutTheNetworkOfMainThingsNamesAreToldAndThatItIsAbsent) {
    FakeHouse house;
    to_picture(house);
    ThingsLookedFor looked = looked_for(house, 0);
    looked.place.things = ThingSearch::absent;
    house.apply(looked);
    EXPECT_EQ(house.last_said(), "The main subject cannot be found here.");
    looked.names = {{ThingName::animal, {0.0, 0.0, 1.0, 1.0}, 0.5}};
    house.apply(looked);
    EXPECT_EQ(house.last_said(),
              "Probably an animal, in most of the picture. The main subject cannot be found here.");
}

TEST(Visit, AFaceIsToldAsOne) {
    FakeHouse house;
    to_picture(house);
    house.apply(looked_for(house, 2));
    PictureFacts facts = house.visit.visitor.felt->facts;
    facts.place = {1, 1, 1, 3, ThingSearch::found, true};
    house.apply(PictureReady{house.last<LoadPicture>()[0].request, facts});
    EXPECT_TRUE(house.has_said("Thing 1 of 2 in the photograph, a face", 0)) << house.last_said();
}

TEST(Visit, TheThingUnderTheHandIsOpenedAndOtherwiseThePictureStays) {
    FakeHouse house;
    to_picture(house);
    EXPECT_FALSE(house.find("Find the thing under my hand")) << "nobody has looked yet";
    HandleSeen handle;
    handle.part = 0;
    handle.place_W = {0.02, -0.01};
    house.apply(handle);
    house.apply(looked_for(house, 1));
    ASSERT_TRUE(house.choose("Find the thing under my hand"));
    LoadPicture wanted = house.last<LoadPicture>()[0];
    ASSERT_TRUE(wanted.thing_at);
    EXPECT_EQ(wanted.view, 2);
    EXPECT_NEAR(wanted.thing_at->x, 0.02, 1e-9);
    const std::uint64_t whole = house.visit.visitor.felt->order.request;
    house.apply(PictureFailed{
        wanted.request, "Nothing clear was found there. Move the handle elsewhere and try again."});
    EXPECT_TRUE(house.has_said("Nothing clear was found there", 0)) << house.last_said();
    EXPECT_EQ(house.open(), VisitScreen::picture);
    EXPECT_EQ(house.visit.visitor.felt->order.request, whole);
    ASSERT_TRUE(house.choose("Find the thing under my hand"));
    wanted = house.last<LoadPicture>()[0];
    PictureFacts facts = house.visit.visitor.felt->facts;
    facts.place = {1, 1, 2, 3, ThingSearch::found};
    house.apply(PictureReady{wanted.request, facts});
    EXPECT_TRUE(house.has_said("Thing 2 of 2 in the photograph", 0)) << house.last_said();
    EXPECT_EQ(house.visit.visitor.felt->order.view, 2);
    EXPECT_FALSE(house.visit.visitor.felt->order.thing_at);
}

TEST(Visit, WhereNobodyCouldLookThatIsNotCalledUnclear) {
    FakeHouse house;
    to_picture(house);
    ThingsLookedFor looked = looked_for(house, 0);
    looked.place.things = ThingSearch::impossible;
    house.apply(looked);
    EXPECT_EQ(house.last_said(), "The main subject cannot be looked for now.");
}

}  // namespace
}  // namespace touchline
