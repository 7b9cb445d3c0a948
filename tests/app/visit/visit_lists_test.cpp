// Tests the lists of pictures: their parts, the way to each picture and to the one beside it.
#include "app/visit/list_parts.h"
#include "tests/app/visit/fake_world.h"
#include "tests/app/visit/visit_scenes.h"

#include <deque>
#include <map>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// As people name them, as a camera does, and as a scanner does; in the order of a list.
std::vector<std::string> two_hundred_and_five_names() {
    std::vector<std::string> names;
    for (int i = 0; i < 9; ++i) names.push_back("2023040" + std::to_string(1 + i) + ".png");
    for (const char* name : {"apple", "boat", "cat", "dog", "eagle", "fish", "garden", "house"})
        for (int i = 1; i <= 7; ++i)
            names.push_back(std::string(name) + " " + std::to_string(i) + ".png");
    for (int i = 0; i < 130; ++i) names.push_back("IMG_" + std::to_string(1000 + i) + ".JPG");
    for (int i = 1; i <= 10; ++i) names.push_back("zebra " + std::to_string(i) + ".pdf");
    return names;
}

void to_stick(FakeHouse& house, const std::vector<std::string>& names) {
    to_choose(house);
    house.apply(StickCame{names, {}});
    ASSERT_TRUE(house.choose("Your USB stick"));
}

std::string focused(const FakeHouse& house) {
    const SpokenScreen screen = house.screen();
    return spoken_item(screen, screen.focus.value(), Language());
}

/// The least presses of keys from the open list to each picture, by its number; found by trying all
/// keys from all places.
std::map<std::size_t, int> presses_to_pictures(const FakeHouse& house) {
    std::map<std::size_t, int> presses;
    std::map<std::vector<std::pair<int, std::size_t>>, int> known;
    std::deque<std::pair<Visit, int>> open{{house.visit, 0}};
    while (!open.empty()) {
        const auto [visit, pressed] = open.front();
        open.pop_front();
        if (visit.visitor.loading) {
            presses.try_emplace(visit.visitor.loading->order.index, pressed);
            continue;
        }
        if (open_screen(visit) != open_screen(house.visit)) continue;
        std::vector<std::pair<int, std::size_t>> place;
        for (const Standing& each : visit.visitor.path) place.emplace_back(each.about, each.focus);
        if (!known.try_emplace(place, pressed).second) continue;
        for (const KeyRole role : {KeyRole::up, KeyRole::down, KeyRole::select})
            open.emplace_back(step(visit, KeyPressed{role}, house.world()).visit, pressed + 1);
    }
    return presses;
}

int most_presses(const FakeHouse& house, std::size_t pictures) {
    const auto presses = presses_to_pictures(house);
    EXPECT_EQ(presses.size(), pictures) << "each is there";
    int most = 0;
    for (const auto& [number, count] : presses) most = std::max(most, count);
    return most;
}

TEST(VisitLists, AnyOfTwoHundredAndFivePicturesIsTwelvePressesAway) {
    FakeHouse house;
    const std::vector<std::string> names = two_hundred_and_five_names();
    ASSERT_EQ(names.size(), 205U);
    to_stick(house, names);
    EXPECT_LE(most_presses(house, names.size()), 12);
}

TEST(VisitLists, AnyOfACamerasTwoHundredAndFiveToo) {
    FakeHouse house;
    std::vector<std::string> names;
    for (int i = 1; i <= 205; ++i) names.push_back("DSC0" + std::to_string(4000 + i) + ".JPG");
    to_stick(house, names);
    EXPECT_LE(most_presses(house, names.size()), 12);
    EXPECT_EQ(focused(house), "Pictures 1 to 34, photo 40 01 to photo 40 34, 1 of 6");
}

TEST(VisitLists, AnyPictureOfTheGalleryIsTwelvePressesAway) {
    FakeHouse house;
    for (auto& titles : house.gallery) {
        titles.clear();
        for (int i = 0; i < 56; ++i)
            titles.push_back({"Picture " + std::to_string(i), "", 1 + i % 5});
    }
    to_choose(house);
    ASSERT_TRUE(house.choose("Gallery"));
    EXPECT_LE(most_presses(house, 56), 12);
}

TEST(VisitLists, APartIsNamedByLettersAndAPictureByItsNumberAmongAll) {
    FakeHouse house;
    to_stick(house, {"apple.png", "ant.png", "boat.png", "cat.png", "dog.png", "12.png", "eel.png",
                     "fish.png", "***.png"});
    // The fake stick is not sorted; its parts are runs of one letter.
    EXPECT_EQ(focused(house), "A to digits, 6 pictures, 1 of 2");
    house.press(KeyRole::down);
    EXPECT_EQ(house.last_said(), "E to other signs, 3 pictures, 2 of 2");
    house.press(KeyRole::down);
    EXPECT_EQ(house.last_said(), "Back") << "no picture, so it is not counted";
    house.press({KeyRole::up, KeyRole::select});
    EXPECT_EQ(house.last_said(), "E to other signs. eel, picture 7 of 9");
    house.press(KeyRole::back);
    EXPECT_EQ(house.open(), VisitScreen::stick);
    EXPECT_EQ(focused(house), "E to other signs, 3 pictures, 2 of 2") << "where it was";
    house.press(KeyRole::back);
    EXPECT_EQ(house.open(), VisitScreen::choose);
}

TEST(VisitLists, APartThatEndsWithinALetterIsNamedByItsNumbersAndTellsWhichTheyAre) {
    FakeHouse house;
    to_stick(house, two_hundred_and_five_names());
    EXPECT_EQ(focused(house), "Pictures 1 to 34, 1st April 2023 to dog 4, 1 of 6");
    house.press(KeyRole::select);
    const std::string inner = "Pictures 1 to 5, 1st April 2023 to 5th April 2023, 1 of 6";
    EXPECT_EQ(house.last_said(), "Pictures 1 to 34. " + inner) << "its row told the rest";
    EXPECT_EQ(house.screen().title, "Pictures 1 to 34") << "what was chosen";
    house.press(KeyRole::select);
    const std::string first = "Pictures 1 to 5. 1st April 2023, picture 1 of 205";
    EXPECT_EQ(house.last_said(), first);
    house.press(KeyRole::select);
    house.wait(0.5);
    ASSERT_TRUE(house.choose("Another picture"));
    EXPECT_EQ(house.last_said(), first);
    house.press(KeyRole::back);
    EXPECT_EQ(house.last_said(), "Pictures 1 to 34. " + inner);
}

TEST(VisitLists, APartThatEndsWithinAGradeTellsItsFirstPicture) {
    FakeHouse house;
    for (auto& titles : house.gallery) {
        titles.clear();
        for (int i = 1; i <= 40; ++i)
            titles.push_back({"Letter " + std::to_string(i), "", i <= 8 ? 1 : i <= 22 ? 2 : 3});
    }
    to_choose(house);
    ASSERT_TRUE(house.choose("Gallery"));
    ASSERT_TRUE(house.choose("easy"));
    EXPECT_EQ(house.last_said(), "easy. Pictures 9 to 12, starting with Letter 9, 1 of 3");
    house.press(KeyRole::select);
    EXPECT_EQ(house.last_said(), "Pictures 9 to 12. Letter 9, picture 9 of 40");
}

TEST(VisitLists, TheOnlyPictureIsNotCounted) {
    FakeHouse house;
    to_stick(house, {"apple.png"});
    EXPECT_EQ(focused(house), "apple");
    house.press(KeyRole::down);
    EXPECT_EQ(house.last_said(), "Back");
}

TEST(VisitLists, APictureAloneUnderItsLetterNeedsNoList) {
    FakeHouse house;
    to_stick(house, {"a1.png", "a2.png", "a3.png", "a4.png", "a5.png", "a6.png", "zebra.png"});
    house.press(KeyRole::down);
    EXPECT_EQ(house.last_said(), "zebra, picture 7 of 7");
    house.press(KeyRole::select);
    EXPECT_EQ(house.visit.visitor.loading->order.index, 6U);
}

TEST(VisitLists, TheGalleryIsPartedByHowHardItsPicturesAre) {
    FakeHouse house;
    to_choose(house);
    ASSERT_TRUE(house.choose("Gallery"));
    EXPECT_TRUE(house.last_said().ends_with("very easy, 2 pictures, 1 of 6")) << house.last_said();
    house.press(KeyRole::select);
    EXPECT_EQ(house.last_said(), "very easy. Picture 5 en, picture 1 of 12");
    house.press(KeyRole::select);
    EXPECT_EQ(house.last<LoadPicture>()[0].index, 4U);
    EXPECT_EQ(house.last<LoadPicture>()[0].source, PictureSource::gallery);
    house.wait(0.5);
    house.press(KeyRole::back);
    ASSERT_TRUE(house.choose("Gallery"));
    ASSERT_TRUE(house.choose("not graded"));
    EXPECT_TRUE(house.last_said().ends_with("Picture 6 en, picture 11 of 12"));
}

TEST(VisitLists, FromAPictureItsListOpensWhereItIsAndItsNeighboursAreOneKeyAway) {
    FakeHouse house;
    to_stick(house, two_hundred_and_five_names());
    ASSERT_TRUE(house.choose_picture("fish 7"));
    EXPECT_EQ(house.visit.visitor.loading->order.index, 50U);
    house.wait(0.5);
    ASSERT_TRUE(house.find("Next picture"));
    EXPECT_EQ(house.screen().items[*house.screen().focus].value, "garden 1");
    for (const std::size_t next : {51U, 52U}) {
        house.press(KeyRole::select);
        EXPECT_EQ(house.visit.visitor.loading->order.index, next);
        house.wait(0.5);
        EXPECT_TRUE(house.last_said().find("Next picture, garden") != std::string::npos)
            << house.last_said();
    }
    ASSERT_TRUE(house.choose("Previous picture"));
    EXPECT_EQ(house.visit.visitor.loading->order.index, 51U);
    house.wait(0.5);
    ASSERT_TRUE(house.choose("Another picture"));
    EXPECT_TRUE(house.last_said().ends_with("garden 1, picture 52 of 205")) << house.last_said();
    EXPECT_EQ(house.open(), VisitScreen::stick);
    for (int i = 0; i < 3; ++i) house.press(KeyRole::back);
    EXPECT_EQ(house.open(), VisitScreen::choose);
}

TEST(VisitLists, TheEndsOfAListHaveOneNeighbour) {
    FakeHouse house;
    to_stick_picture(house, 2);
    EXPECT_FALSE(house.find("Previous picture"));
    ASSERT_TRUE(house.choose("Next picture"));
    house.wait(0.5);
    EXPECT_FALSE(house.find("Next picture"));
    EXPECT_TRUE(house.find("Previous picture"));
    house.press(KeyRole::back);
    ASSERT_TRUE(house.choose("Practice shape"));
    house.wait(0.5);
    EXPECT_FALSE(house.find("Next picture"));
}

TEST(VisitLists, AHeldKeyJumpsAScreenAndStopsAtTheEnd) {
    FakeHouse house;
    to_picture(house);
    const SpokenScreen before = house.screen();
    ASSERT_GT(before.items.size(), items_on_screen);
    house.apply(KeyHeld{KeyRole::down});
    EXPECT_EQ(house.screen().focus, items_on_screen - 1);
    EXPECT_TRUE(house.last_said().starts_with(before.items[items_on_screen - 1].name));
    for (int i = 0; i < 5; ++i) house.apply(KeyHeld{KeyRole::down});
    EXPECT_EQ(house.screen().focus, before.items.size() - 1) << "never over the end";
    EXPECT_EQ(house.last<GiveCue>()[0].event, ScreenEvent::list_end);
    for (int i = 0; i < 5; ++i) house.apply(KeyHeld{KeyRole::up});
    EXPECT_EQ(house.screen().focus, 0U);
    house.apply(KeyHeld{KeyRole::select});
    EXPECT_EQ(house.open(), VisitScreen::picture) << "only Up and Down";
}

TEST(VisitLists, AKeyThatIsHeldByAThingIsNoVisitor) {
    FakeHouse house;
    to_choose(house);
    while (house.open() != VisitScreen::question) {
        house.apply(KeyHeld{KeyRole::down});
        house.wait(1.0);
        ASSERT_LT(house.now_s, 200.0);
    }
    house.apply(KeyHeld{KeyRole::down});
    EXPECT_EQ(house.open(), VisitScreen::question);
}

TEST(VisitLists, WhoeverIsInAPartOfAStickThatGoesIsInTheListOfTheNext) {
    FakeHouse house;
    to_stick(house, two_hundred_and_five_names());
    house.press({KeyRole::select, KeyRole::down, KeyRole::select});
    house.apply(StickGone{});
    EXPECT_EQ(house.open(), VisitScreen::stick);
    house.apply(StickCame{{"a.png"}, {}});
    EXPECT_EQ(house.screen().items.size(), 2U);
    EXPECT_EQ(house.screen().title, "Your USB stick");
}

TEST(VisitLists, WhoeverIsInTheListOfAStickThatGoesHearsWhatHappenedAndWhatToDo) {
    FakeHouse house;
    to_stick(house, two_hundred_and_five_names());
    house.press(KeyRole::select);
    house.apply(StickGone{});
    EXPECT_EQ(house.last_said(),
              "The USB stick is out. Put a USB stick into the slot; nothing is written to it. "
              "Back");
    house.apply(StickCame{{"apple.png"}, {}});
    house.press(KeyRole::select);
    house.wait(0.5);
    ASSERT_TRUE(house.choose("Another picture"));
    house.apply(StickGone{});
    EXPECT_TRUE(house.last_said().starts_with(
        "The USB stick is out. Your picture stays open. Put a USB stick "))
        << house.last_said();
}

TEST(VisitLists, PicturesGivenAtTheStartStayForEveryVisitor) {
    FakeHouse house;
    house.apply(PicturesGiven{{"apple.png", "boat.png"}});
    EXPECT_TRUE(house.transcript.empty()) << "nobody is here";
    for (int visitor = 0; visitor < 2; ++visitor) {
        to_choose(house);
        ASSERT_TRUE(house.choose("Your USB stick"));
        ASSERT_TRUE(house.choose("boat"));
        house.wait(0.5);
        EXPECT_EQ(house.visit.visitor.felt->order.index, 1U);
        finish(house);
        EXPECT_EQ(house.last_said().find("Take your USB stick"), std::string::npos);
    }
    to_choose(house);
    ASSERT_TRUE(house.choose("Settings"));
    ASSERT_TRUE(house.choose("Start over"));
    ASSERT_TRUE(house.choose("Yes"));
    house.press(KeyRole::select);
    EXPECT_TRUE(house.find("Your USB stick"));
    EXPECT_EQ(house.screen().items[*house.screen().focus].value, "2 pictures");
}

TEST(VisitLists, AStickReplacesThePicturesGivenAtTheStartWhileItIsThere) {
    FakeHouse house;
    house.apply(PicturesGiven{{"apple.png", "boat.png"}});
    to_choose(house);
    house.apply(StickArriving{});
    house.apply(StickCame{{"cat.png"}, {}});
    ASSERT_TRUE(house.choose("Your USB stick"));
    EXPECT_EQ(house.screen().items[0].name, "cat");
    house.apply(StickGone{});
    EXPECT_EQ(house.last_said(), "The USB stick is out. Your USB stick. apple, picture 1 of 2");
    EXPECT_EQ(house.screen().items[0].name, "apple");
    house.apply(StickCame{{"cat.png"}, {}});
    house.press(KeyRole::back);
    finish(house);
    EXPECT_NE(house.last_said().find("Take your USB stick"), std::string::npos);
}

TEST(VisitLists, AFileThatCannotBeOpenedIsToldByItsNameAndPartsOfAPictureWithoutOne) {
    FakeHouse house;
    to_choose(house);
    house.apply(StickCame{{"boat.png", "my_letter.png"}, {}});
    ASSERT_TRUE(house.choose("Your USB stick"));
    ASSERT_TRUE(house.choose("my letter"));
    house.apply(PictureFailed{house.visit.site.request, "The file is damaged. Choose another."});
    EXPECT_TRUE(house.last_said().starts_with(
        "Something is wrong. my letter cannot be opened. The file is damaged. Choose another."))
        << house.last_said();
    house.press(KeyRole::select);
    ASSERT_TRUE(house.choose("boat"));
    house.wait(0.5);
    ASSERT_TRUE(house.choose("Enlargement"));
    ASSERT_TRUE(house.choose("Twice as large, around your hand"));
    house.apply(PictureFailed{house.visit.site.request, "There is no line in this part."});
    EXPECT_TRUE(house.last_said().starts_with("Something is wrong. There is no line in this part."))
        << house.last_said();
}

TEST(VisitLists, AnyPageOfALongDocumentIsChosenInParts) {
    FakeHouse house;
    to_stick_picture(house);
    PictureFacts facts = house.visit.visitor.felt->facts;
    facts.place = {1, 40, 1, 1};
    house.apply(PictureReady{house.visit.visitor.felt->order.request, facts});
    ASSERT_TRUE(house.choose("Pages"));
    ASSERT_TRUE(house.choose("Pages 21 to 40"));
    EXPECT_EQ(house.last_said(), "Pages 21 to 40. Pages 21 to 25, 1 of 5");
    ASSERT_TRUE(house.choose("Pages 36 to 40"));
    EXPECT_FALSE(house.find("Go to the next page")) << "a part has its rows alone";
    ASSERT_TRUE(house.choose("Page 37"));
    EXPECT_EQ(house.last<LoadPicture>()[0].page, 37);
    EXPECT_EQ(house.last<LoadPicture>()[0].view, 1);
    house.wait(0.5);
    EXPECT_EQ(house.open(), VisitScreen::picture);
}

TEST(VisitLists, OfThousandsAreThreeDeepToo) {
    FakeHouse house;
    std::vector<std::string> names;
    for (int i = 0; i < 3000; ++i) names.push_back("IMG_" + std::to_string(1000 + i) + ".JPG");
    to_stick(house, names);
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(house.open(), VisitScreen::stick);
        house.press(KeyRole::select);
    }
    EXPECT_EQ(house.visit.visitor.loading->order.index, 0U);
}

}  // namespace
}  // namespace touchline
