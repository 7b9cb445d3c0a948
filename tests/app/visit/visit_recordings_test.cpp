// Tests which of what a visitor hears is recorded, in a house whose pictures are.
#include "tests/app/visit/fake_world.h"
#include "tests/app/visit/visit_scenes.h"

#include <gtest/gtest.h>

namespace touchline {
namespace {

VoiceRecordingPtr recorded(double long_s) {
    std::vector<std::int16_t> samples(static_cast<std::size_t>(long_s * frame_rate_Hz), 1);
    return std::make_shared<const VoiceRecording>(VoiceRecording{std::move(samples)});
}

const VoiceRecordingPtr title_sound = recorded(1.0);
const VoiceRecordingPtr description_sound = recorded(20.0);
const VoiceRecordingPtr body_sound = recorded(2.0);
const VoiceRecordingPtr tail_sound = recorded(9.0);

/// Opens a picture and then knows its recordings, as if it had come with them.
void to_recorded_picture(FakeHouse& house) {
    to_picture(house);
    PictureFacts facts = house.visit.visitor.felt->facts;
    facts.title_recording = title_sound;
    facts.description_recording = description_sound;
    facts.parts[0].recording = body_sound;
    facts.parts[1].recording = tail_sound;
    house.apply(PictureReady{house.visit.visitor.felt->order.request, facts});
}

/// What was said last in recordings: their words and the recordings, in order.
std::vector<SpeechPiece> last_recorded(const FakeHouse& house) {
    for (auto at = house.all_orders.rbegin(); at != house.all_orders.rend(); ++at) {
        const auto* const said = std::get_if<Utterance>(&*at);
        if (said == nullptr) continue;
        SpokenText text(said->text);
        text.recorded = said->recorded;
        std::vector<SpeechPiece> pieces = pieces_of(text);
        std::erase_if(pieces, [](const SpeechPiece& piece) { return !piece.recording; });
        return pieces;
    }
    return {};
}

using Pieces = std::vector<SpeechPiece>;

TEST(VisitRecordings, TitleAndDescriptionArePlayedAndTheRestIsSaid) {
    FakeHouse house;
    to_recorded_picture(house);
    ASSERT_TRUE(house.choose("Tell me again"));
    const PictureFacts& facts = house.visit.visitor.felt->facts;
    const Pieces wanted{{facts.title, title_sound}, {facts.description, description_sound}};
    EXPECT_EQ(last_recorded(house), wanted);
    EXPECT_NE(house.last_said().find("5 outlines"), std::string::npos);
    EXPECT_EQ(house.visit.visitor.caption.text, house.last_said());
    house.press(KeyRole::repeat);
    EXPECT_EQ(last_recorded(house), wanted);
    house.press(KeyRole::repeat);
    EXPECT_EQ(last_recorded(house), wanted) << "the whole screen, too";
}

TEST(VisitRecordings, WhoComesBackHearsAShortTitle) {
    FakeHouse house;
    to_recorded_picture(house);
    ASSERT_TRUE(house.choose("Parts"));
    house.press(KeyRole::back);
    EXPECT_EQ(last_recorded(house), (Pieces{{house.visit.visitor.felt->facts.title, title_sound}}));
    PictureFacts facts = house.visit.visitor.felt->facts;
    facts.title_recording = recorded(30.0);
    house.apply(PictureReady{house.visit.visitor.felt->order.request, facts});
    ASSERT_TRUE(house.choose("Parts"));
    house.press(KeyRole::back);
    EXPECT_TRUE(last_recorded(house).empty());
}

TEST(VisitRecordings, AListOfPartsHasTheShortOnes) {
    FakeHouse house;
    to_recorded_picture(house);
    ASSERT_TRUE(house.choose("Parts"));
    EXPECT_EQ(last_recorded(house), (Pieces{{"Body en", body_sound}}));
    house.press(KeyRole::down);
    EXPECT_TRUE(house.last_said().starts_with("Tail en, ")) << house.last_said();
    EXPECT_TRUE(last_recorded(house).empty()) << "its place would come nine seconds later";
}

TEST(VisitRecordings, APartUnderTheHandIsPlayedWhole) {
    FakeHouse house;
    to_recorded_picture(house);
    HandleSeen seen;
    seen.part = 1;
    seen.has_moved = true;
    house.apply(seen);
    house.wait(1.0);
    EXPECT_EQ(last_recorded(house), (Pieces{{"Tail en", tail_sound}}));
    const auto is_of_hand = [&house] {
        for (auto at = house.all_orders.rbegin(); at != house.all_orders.rend(); ++at)
            if (const auto* const said = std::get_if<Utterance>(&*at)) return said->is_of_hand;
        return false;
    };
    EXPECT_TRUE(is_of_hand()) << "the next part takes its place";
    house.press(KeyRole::down);
    EXPECT_FALSE(is_of_hand());
    EXPECT_EQ(house.last<Hush>().size(), 1U);
}

TEST(VisitRecordings, WhoeverListensIsThere) {
    FakeHouse house;
    to_recorded_picture(house);
    PictureFacts facts = house.visit.visitor.felt->facts;
    facts.description_recording = recorded(100.0);
    house.apply(PictureReady{house.visit.visitor.felt->order.request, facts});
    ASSERT_TRUE(house.choose("Tell me again"));
    house.wait(100.0 + house.rules.inactivity_s - 1.0);
    EXPECT_EQ(house.open(), VisitScreen::picture);
    house.wait(3.0);
    EXPECT_EQ(house.open(), VisitScreen::question);
    house.press(KeyRole::select);
    ASSERT_TRUE(house.choose("Tell me again"));
    house.press(KeyRole::down);
    house.wait(house.rules.inactivity_s + 1.0);
    EXPECT_EQ(house.open(), VisitScreen::question) << "a key stopped it";
}

TEST(VisitRecordings, OfTheGalleryAreInItsRows) {
    FakeHouse house;
    for (GalleryTitle& each : house.gallery.front()) each.title_recording = title_sound;
    house.press(KeyRole::select);
    house.press(KeyRole::select);
    ASSERT_TRUE(house.choose("Gallery"));
    ASSERT_TRUE(house.choose_picture("Picture 4 en"));
    house.press(KeyRole::back);
    ASSERT_TRUE(house.find("Picture 4 en"));
    EXPECT_EQ(last_recorded(house), (Pieces{{"Picture 4 en", title_sound}})) << house.last_said();
}

TEST(VisitRecordings, NothingOfThemStays) {
    FakeHouse house;
    to_recorded_picture(house);
    const std::weak_ptr<const VoiceRecording> own = [&] {
        PictureFacts facts = house.visit.visitor.felt->facts;
        const VoiceRecordingPtr made = recorded(0.1);
        facts.title_recording = made;
        house.apply(PictureReady{house.visit.visitor.felt->order.request, facts});
        return std::weak_ptr(made);
    }();
    ASSERT_TRUE(house.choose("Tell me again"));
    EXPECT_FALSE(own.expired());
    house.wait(200.0);
    EXPECT_FALSE(is_visit_on(house.visit));
    house.orders.clear();
    house.all_orders.clear();
    EXPECT_TRUE(own.expired());
}

}  // namespace
}  // namespace touchline
