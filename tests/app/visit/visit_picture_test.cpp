// Tests the picture, the hand on it and the handle that leads: HA of the requirements.
#include "tests/app/visit/fake_world.h"
#include "tests/app/visit/visit_scenes.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// The index of the first order of a kind; the number of orders if there is none.
template <class Order>
std::size_t place_of_first(const VisitOrders& orders) {
    const auto found = std::find_if(orders.begin(), orders.end(), [](const VisitOrder& order) {
        return std::holds_alternative<Order>(order);
    });
    return static_cast<std::size_t>(found - orders.begin());
}

TEST(Visit, HA1_TheHandleLeadsOnlyAfterAKeyAndItsAnnouncement) {
    FakeHouse house;
    to_picture(house);
    ASSERT_TRUE(house.choose("Guide me along the largest outline"));
    EXPECT_NE(house.last_said().find("The handle will guide you along the outline."),
              std::string::npos);
    EXPECT_NE(house.last_said().find("Press any key to stop it."), std::string::npos);
    EXPECT_TRUE(house.last<Guide>().empty());
    house.wait(1.9);
    EXPECT_FALSE(house.is_leading) << "the announcement comes first";
    house.wait(0.2);
    EXPECT_TRUE(house.is_leading);
    EXPECT_EQ(house.visit.visitor.leading->guide.kind, GuideKind::outline);
    EXPECT_EQ(house.visit.visitor.leading->guide.outline, 0);
}

TEST(Visit, HA1_SlowSpeechHasTheTimeItNeeds) {
    FakeHouse house;
    to_picture(house);
    for (int i = 0; i < 3; ++i) house.apply(SpeechKeyPressed{SpeechKey::slower});
    ASSERT_TRUE(house.choose("Guide me along the largest outline"));
    house.wait(3.9);
    EXPECT_FALSE(house.is_leading);
    house.wait(0.2);
    EXPECT_TRUE(house.is_leading);
}

TEST(Visit, HA1_AnyKeyStopsInTheSameStepAndDoesNothingElse) {
    std::vector<VisitEvent> keys{DeadKeyPressed{}, SpeechKeyPressed{SpeechKey::pause},
                                 SpeechKeyPressed{SpeechKey::faster}};
    for (std::size_t role = 0; role < key_role_count; ++role) {
        keys.emplace_back(KeyPressed{static_cast<KeyRole>(role)});
    }
    for (const VisitEvent& key : keys) {
        for (const double after_s : {0.5, 3.0}) {  // while it is announced, and while it leads
            FakeHouse house;
            to_picture(house);
            house.lead_s = 100.0;
            ASSERT_TRUE(house.choose("Guide me along the largest outline"));
            house.wait(after_s);
            const auto path = house.visit.visitor.path;
            house.apply(key);
            ASSERT_EQ(house.last<Guide>().size(), 1U) << key.index();
            EXPECT_EQ(house.last<Guide>()[0].kind, GuideKind::stop);
            EXPECT_EQ(house.visit.visitor.path, path);
            EXPECT_EQ(house.open(), VisitScreen::picture);
            house.wait(10.0);
            EXPECT_FALSE(house.is_leading);
        }
    }
}

TEST(Visit, HA1_NothingElseEverLeads) {
    FakeHouse house;
    to_picture(house);
    ASSERT_TRUE(house.choose("Explore freely"));
    HandleSeen on_part;
    on_part.part = 1;
    on_part.has_moved = true;
    for (int i = 0; i < 100; ++i) {
        house.apply(on_part);
        house.wait(0.1);
    }
    house.apply(TroubleBegan{TroubleKind::camera, ""});
    house.wait(200.0);
    for (const VisitOrder& order : house.all_orders) {
        const auto* guide = std::get_if<Guide>(&order);
        EXPECT_TRUE(guide == nullptr || guide->kind == GuideKind::stop);
    }
}

TEST(Visit, HA3_FocusChoiceErrorEdgeAndTimeOutShakeDifferently) {
    FakeHouse house;
    to_choose(house);
    const auto shakes = [&house](const HandlePattern pattern) {
        return house.last<GivePattern>().size() == 1 &&
               house.last<GivePattern>()[0].pattern == pattern;
    };
    house.press(KeyRole::down);
    EXPECT_TRUE(shakes(HandlePattern::focus));
    house.press({KeyRole::up, KeyRole::up});
    EXPECT_TRUE(shakes(HandlePattern::edge));
    house.apply(DeadKeyPressed{});
    EXPECT_TRUE(shakes(HandlePattern::error));
    ASSERT_TRUE(house.choose("Settings"));
    EXPECT_TRUE(shakes(HandlePattern::chosen));
    while (house.open() != VisitScreen::question) house.wait(0.05);
    EXPECT_TRUE(shakes(HandlePattern::time_out));
}

TEST(Visit, HA4_FirmnessAndKindOfLineHaveNamesAndKeepThePicture) {
    FakeHouse house;
    to_picture(house);
    const std::size_t loads = house.visit.site.request;
    EXPECT_EQ(stiffness_steps[house.visit.visitor.feel.stiffness].share, 1.0) << "the operator's";
    for (const char* name : {"very soft", "soft", "medium", "firm"}) {
        ASSERT_TRUE(house.choose("Firmness"));
        ASSERT_TRUE(house.choose(name));
        EXPECT_EQ(house.open(), VisitScreen::picture);
        EXPECT_TRUE(house.last_said().starts_with(std::string("Firmness, ") + name));
        const bool is_new = std::string(name) != "medium" || !house.last<Feel>().empty();
        EXPECT_TRUE(is_new);
        EXPECT_EQ(stiffness_steps[house.visit.visitor.feel.stiffness].name, name);
        EXPECT_TRUE(house.visit.visitor.feel.is_force_wanted);
    }
    for (const char* name : {"wall", "ridge", "sticky line", "groove"}) {
        ASSERT_TRUE(house.choose("Kind of line"));
        ASSERT_TRUE(house.choose(name));
        ASSERT_EQ(house.last<Feel>().size(), 1U) << "at once";
    }
    EXPECT_EQ(house.visit.visitor.feel.mode, Mode::groove);
    EXPECT_EQ(house.visit.site.request, loads) << "nothing was opened again";
}

TEST(Visit, HA4_DetailIsOpenedAgainAndSaid) {
    FakeHouse house;
    to_picture(house);
    ASSERT_TRUE(house.choose("Detail"));
    ASSERT_TRUE(house.choose("everything"));
    EXPECT_EQ(house.last<LoadPicture>()[0].detail, 5);
    EXPECT_TRUE(house.visit.visitor.felt) << "what is felt stays meanwhile";
    house.wait(0.5);
    EXPECT_EQ(house.open(), VisitScreen::picture);
    EXPECT_TRUE(house.has_said("Thing 4 en. 7 outlines. Detail, everything", 0))
        << house.last_said();
}

TEST(Visit, TheLastChangeIsUndoneAndSaid) {
    FakeHouse house;
    to_picture(house);
    EXPECT_FALSE(house.find("Undo the last change")) << "there is none yet";
    ASSERT_TRUE(house.choose("Kind of line"));
    ASSERT_TRUE(house.choose("wall"));
    ASSERT_TRUE(house.find("Another picture"));
    house.press(KeyRole::up);
    EXPECT_TRUE(house.last_said().starts_with("Undo the last change, Kind of line"));
    house.press(KeyRole::select);
    EXPECT_EQ(house.visit.visitor.feel.mode, Mode::groove);
    EXPECT_TRUE(house.last_said().starts_with("Kind of line, groove"));
    ASSERT_TRUE(house.choose("Enlargement"));
    ASSERT_TRUE(house.choose("Twice as large, around your hand"));
    house.wait(0.5);
    ASSERT_EQ(house.visit.visitor.felt->order.zoom.factor, 2.0);
    ASSERT_TRUE(house.choose("Undo the last change"));
    house.wait(0.5);
    EXPECT_EQ(house.visit.visitor.felt->order.zoom.factor, 1.0);
    EXPECT_TRUE(house.last_said().starts_with("The whole picture."));
    ASSERT_TRUE(house.choose("Detail"));
    ASSERT_TRUE(house.choose("everything"));
    house.wait(0.5);
    ASSERT_TRUE(house.choose("Undo the last change"));
    house.wait(0.5);
    EXPECT_EQ(house.visit.visitor.felt->order.detail, 3);
    EXPECT_EQ(house.visit.visitor.detail, 3);
    EXPECT_NE(house.last_said().find("5 outlines. Detail, parts"), std::string::npos);
    ASSERT_TRUE(house.choose("Another picture"));
    house.press(KeyRole::select);
    house.wait(0.5);
    EXPECT_FALSE(house.find("Undo the last change")) << "of another picture";
}

/// Changes a setting and tells the visit, as the kiosk does.
void set(FakeHouse& house, void (*change)(Settings&)) {
    const Settings before = house.settings;
    change(house.settings);
    house.apply(SettingsChanged{before});
}

TEST(Visit, TheOperatorsDetailOpensWhatIsFeltAgainWithoutAWord) {
    FakeHouse house;
    to_picture(house);
    const LoadPicture felt = house.visit.visitor.felt->order;
    const std::size_t heard = house.transcript.size();
    const std::vector<Standing> path = house.visit.visitor.path;
    set(house, [](Settings& settings) { settings.detail = 5; });
    set(house, [](Settings& settings) { settings.detail = 4; });
    ASSERT_EQ(house.last<LoadPicture>().size(), 1U);
    house.wait(0.5);
    LoadPicture wanted = felt;
    wanted.detail = 4;
    wanted.request = house.visit.site.request;
    EXPECT_EQ(house.visit.visitor.felt->order, wanted);
    EXPECT_EQ(house.visit.visitor.detail, 4);
    EXPECT_EQ(house.visit.visitor.path, path);
    EXPECT_EQ(house.transcript.size(), heard);
    set(house, [](Settings& settings) { settings.friction = 0.5; });
    EXPECT_TRUE(house.last<LoadPicture>().empty());
}

TEST(Visit, TheOperatorsDetailHoldsForWhatIsBeingOpened) {
    FakeHouse house;
    to_picture(house);
    ASSERT_TRUE(house.choose("Enlargement"));
    ASSERT_TRUE(house.choose("Twice as large, around your hand"));
    set(house, [](Settings& settings) { settings.detail = 1; });
    house.wait(0.5);
    EXPECT_EQ(house.visit.visitor.felt->order.detail, 1);
    EXPECT_EQ(house.visit.visitor.felt->order.zoom.factor, 2.0);
    EXPECT_EQ(house.open(), VisitScreen::picture);
    EXPECT_TRUE(house.has_said("Now 2 times as large.", 0));
}

/// The later choice of the visitor or the operator holds; one that was not reached does not.
TEST(Visit, ADetailThatIsNotReachedIsNotKept) {
    FakeHouse house;
    to_picture(house);
    house.loads_fail = true;
    set(house, [](Settings& settings) { settings.detail = 2; });
    house.wait(0.5);
    EXPECT_EQ(house.visit.visitor.detail, 3);
    EXPECT_EQ(house.open(), VisitScreen::picture);
    ASSERT_TRUE(house.choose("Detail"));
    ASSERT_TRUE(house.choose("everything"));
    house.press(KeyRole::back);
    EXPECT_EQ(house.visit.visitor.detail, 3) << "cancelled";
}

/// The operator's detail holds whatever happens to what is being opened.
TEST(Visit, TheOperatorsDetailHoldsWhenWhatIsBeingOpenedDoesNotCome) {
    for (const bool is_cancelled : {true, false}) {
        FakeHouse house;
        to_picture(house);
        const std::size_t felt = house.visit.visitor.felt->order.index;
        ASSERT_TRUE(house.choose("Enlargement"));
        house.loads_fail = true;
        ASSERT_TRUE(house.choose("Twice as large, around your hand"));
        set(house, [](Settings& settings) { settings.detail = 1; });
        house.loads_fail = false;
        if (is_cancelled) house.press(KeyRole::back);
        house.wait(1.0);
        EXPECT_EQ(house.visit.visitor.detail, 1) << is_cancelled;
        EXPECT_EQ(house.visit.visitor.felt->order.detail, 1);
        EXPECT_EQ(house.visit.visitor.felt->order.index, felt);
        EXPECT_EQ(house.visit.visitor.felt->order.zoom.factor, 1.0);
    }
}

TEST(Visit, TheOperatorsDetailOutlastsACaptureThatIsCancelled) {
    FakeHouse house;
    to_picture(house);
    house.visit.visitor.is_capturing = true;
    house.visit.visitor.path.push_back({VisitScreen::opening, 0});
    set(house, [](Settings& settings) { settings.detail = 1; });
    house.press(KeyRole::back);
    house.wait(1.0);
    EXPECT_EQ(house.visit.visitor.felt->order.detail, 1);
}

TEST(Visit, TheOperatorsKindOfLineIsFeltAtOnceAndTheNextVisitorsToo) {
    FakeHouse house;
    to_picture(house);
    set(house, [](Settings& settings) { settings.mode = Mode::wall; });
    ASSERT_EQ(house.last<Feel>().size(), 1U);
    EXPECT_EQ(house.visit.visitor.feel.mode, Mode::wall);
    ASSERT_TRUE(house.choose("Kind of line"));
    ASSERT_TRUE(house.choose("ridge"));
    set(house, [](Settings& settings) { settings.friction = 0.5; });
    EXPECT_EQ(house.visit.visitor.feel.mode, Mode::ridge);
}

TEST(Visit, TheOperatorsSettingsDisturbNobodyWhoFeelsNothing) {
    FakeHouse house;
    for (const bool is_on : {false, true}) {
        if (is_on) to_choose(house);
        const std::size_t heard = house.transcript.size();
        set(house, [](Settings& settings) { settings.detail = settings.detail % 5 + 1; });
        EXPECT_TRUE(house.orders.empty());
        EXPECT_EQ(house.transcript.size(), heard);
        EXPECT_EQ(house.visit.visitor.detail, house.settings.detail);
    }
}

TEST(Visit, HA5_APracticeShapeIsOfferedFirstAndCanBeSkipped) {
    FakeHouse house;
    to_choose(house);
    EXPECT_TRUE(house.has_said("Begin with a practice shape", 0));
    EXPECT_EQ(house.screen().items[0].name, "Practice shape");
    house.press(KeyRole::select);
    EXPECT_EQ(house.last<LoadPicture>()[0].source, PictureSource::practice);
    house.wait(0.5);
    EXPECT_EQ(house.open(), VisitScreen::practice);
    ASSERT_TRUE(house.choose("Another shape"));
    EXPECT_EQ(house.last<LoadPicture>()[0].index, 1U);
    house.wait(0.5);
    const std::size_t before = house.transcript.size();
    house.wait(59.0);
    EXPECT_FALSE(house.has_said("This is enough for practice.", before));
    house.wait(1.5);
    EXPECT_FALSE(house.has_said("This is enough for practice.", before)) << "of none at all";
    HandleSeen on_line;
    on_line.part = 0;
    house.apply(on_line);
    house.wait(0.1);
    EXPECT_FALSE(house.has_said("This is enough for practice.", before)) << "nobody moved";
    on_line.has_moved = true;
    house.apply(on_line);
    house.wait(0.1);
    EXPECT_TRUE(house.has_said("This is enough for practice.", before));
    house.press(KeyRole::back);
    EXPECT_EQ(house.open(), VisitScreen::gallery);
    EXPECT_TRUE(house.last_said().starts_with("Gallery.")) << "on to the pictures";
    EXPECT_NE(house.last_said().find("very easy, 2 pictures"), std::string::npos);
    house.press(KeyRole::back);
    EXPECT_EQ(house.open(), VisitScreen::choose);
    EXPECT_FALSE(house.find("Back to the picture")) << "a practice shape is none";
    house.gallery.front().clear();
    ASSERT_TRUE(house.choose("Practice shape"));
    house.wait(0.5);
    house.press(KeyRole::back);
    EXPECT_EQ(house.open(), VisitScreen::choose);
}

TEST(Visit, WhatComesBeforeTheItemDoesNotMoveTheFocusFromIt) {
    FakeHouse house;
    to_picture(house);
    ASSERT_TRUE(house.choose("Enlargement"));
    ASSERT_TRUE(house.choose("Twice as large, around your hand"));
    PictureFacts empty = house.visit.visitor.felt->facts;
    empty.parts.clear();
    empty.outline_count = 0;
    house.apply(PictureReady{house.last<LoadPicture>()[0].request, empty});
    EXPECT_NE(house.last_said().find("You feel the middle of the picture. Enlargement, "),
              std::string::npos)
        << house.last_said();
}

TEST(Visit, ZoomGoesAroundTheHandInThePlaceOfTheWholePicture) {
    FakeHouse house;
    to_picture(house);
    HandleSeen handle;
    handle.place_W = {0.02, 0.01};
    house.apply(handle);
    ASSERT_TRUE(house.choose("Enlargement"));
    ASSERT_TRUE(house.choose("Twice as large, around your hand"));
    EXPECT_EQ(house.last<LoadPicture>()[0].zoom, (ZoomWanted{2.0, {0.02, 0.01}}));
    house.wait(0.5);
    EXPECT_TRUE(house.has_said("Now 2 times as large. You feel the right of the picture.", 0))
        << house.last_said();
    house.apply(handle);
    ASSERT_TRUE(house.choose("Enlargement"));
    ASSERT_TRUE(house.choose("Four times as large, around your hand"));
    const ZoomWanted zoom = house.last<LoadPicture>()[0].zoom;
    EXPECT_DOUBLE_EQ(zoom.centre.x, 0.03);
    EXPECT_DOUBLE_EQ(zoom.centre.y, 0.015);
    house.wait(0.5);
    ASSERT_TRUE(house.choose("Enlargement"));
    ASSERT_TRUE(house.choose("The whole picture"));
    EXPECT_EQ(house.last<LoadPicture>()[0].zoom, ZoomWanted{});
}

TEST(Visit, ZoomGoesAroundAPartTwiceThenFourTimes) {
    FakeHouse house;
    to_picture(house);
    ASSERT_TRUE(house.choose("Enlargement"));
    ASSERT_TRUE(house.choose("Tail en"));
    EXPECT_EQ(house.last<LoadPicture>()[0].zoom, (ZoomWanted{2.0, {0.04, -0.02}}));
    house.wait(0.5);
    // The middle of what is felt now.
    PictureFacts facts = house.visit.visitor.felt->facts;
    facts.parts[1].place_W = {};
    house.apply(PictureReady{house.visit.visitor.felt->order.request, facts});
    ASSERT_TRUE(house.choose("Enlargement"));
    ASSERT_TRUE(house.choose("Tail en"));
    EXPECT_EQ(house.last<LoadPicture>()[0].zoom, (ZoomWanted{4.0, {0.04, -0.02}}));
}

TEST(Visit, PagesAndTheirPicturesAreWalkedThrough) {
    FakeHouse house;
    to_stick_picture(house);
    EXPECT_TRUE(house.has_said("Page 1 of 2. Picture 1 of 2 on this page", 0));
    ASSERT_TRUE(house.choose("Pages"));
    EXPECT_FALSE(house.find("Go to the previous page"));
    ASSERT_TRUE(house.choose("Next picture of the page"));
    EXPECT_EQ(house.last<LoadPicture>()[0].view, 2);
    house.wait(0.5);
    EXPECT_TRUE(house.has_said("The whole page", house.transcript.size() - 1)) << "the next one";
    house.press(KeyRole::select);
    EXPECT_EQ(house.last<LoadPicture>()[0].view, 3);
    house.wait(0.5);
    EXPECT_EQ(house.last_said(), "Page 1 of 2. The whole page. 5 outlines. Back");
    ASSERT_TRUE(house.choose("Go to the next page"));
    EXPECT_EQ(house.last<LoadPicture>()[0].page, 2);
    EXPECT_EQ(house.last<LoadPicture>()[0].view, 1);
    house.wait(0.5);
    EXPECT_EQ(house.last_said(),
              "Page 2 of 2. Picture 1 of 2 on this page. 5 outlines. This is the last page. Back");
    EXPECT_FALSE(house.find("Go to the next page"));
    EXPECT_TRUE(house.find("Go to the previous page"));
    ASSERT_TRUE(house.choose("Back"));
    EXPECT_EQ(house.open(), VisitScreen::picture);
    EXPECT_NE(house.last_said().find("Pages"), std::string::npos);
}

TEST(Visit, LaterFactsOfTheSamePictureAreTaken) {
    FakeHouse house;
    to_picture(house);
    PictureFacts better = house.visit.visitor.felt->facts;
    better.parts.push_back({"Nose", {0.0, 0.0}, {0.0, 0.0}, 1, std::nullopt});
    house.apply(PictureReady{house.visit.visitor.felt->order.request, better});
    EXPECT_EQ(house.last_said(), "1 name was found in the picture.");
    EXPECT_EQ(house.last<Utterance>()[0].priority, SpeechPriority::hint);
    EXPECT_EQ(house.open(), VisitScreen::picture);
    ASSERT_TRUE(house.choose("Parts"));
    EXPECT_TRUE(house.find("Nose"));
    house.apply(PictureReady{house.visit.visitor.felt->order.request + 7, {}});
    EXPECT_EQ(house.visit.visitor.felt->facts.parts.size(), 3U) << "another request's";
}

TEST(Visit, TheFirstWordsOfAPictureAreItsTitleThenHowItIsDrawn) {
    FakeHouse house;
    to_picture(house);
    const std::string told = house.last_said();
    const auto title = told.find("Thing 4 en");
    const auto drawn = told.find("From the side");
    const auto outlines = told.find("5 outlines");
    const auto item = told.find("Guide me along the largest outline");
    EXPECT_EQ(title, 0U);
    EXPECT_LT(title, drawn);
    EXPECT_LT(drawn, outlines);
    EXPECT_LT(outlines, item);
    EXPECT_NE(item, std::string::npos);
    house.wait(2.0);
    EXPECT_EQ(house.last_said(), "Press Select to begin.");
}

TEST(Visit, OrdersOfSoundComeBeforeWhatIsSaid) {
    FakeHouse house;
    to_choose(house);
    house.press(KeyRole::louder);
    EXPECT_LT(place_of_first<SoundWanted>(house.orders), place_of_first<Utterance>(house.orders));
    EXPECT_LT(place_of_first<Hush>(house.orders), place_of_first<Utterance>(house.orders));
}

}  // namespace
}  // namespace touchline
