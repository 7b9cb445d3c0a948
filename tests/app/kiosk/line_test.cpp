// Tests what the kiosk puts on a braille display, and what it takes from its keys.
#include "tests/app/kiosk/blind_visitor.h"
#include "tests/machines/sim/kiosk/due_jobs.h"

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(KioskLine, HA3_ThePartUnderTheHandIsThereAtOnce) {
    KioskWorld world;
    BlindVisitor visitor(world, 0.5, Sense::fingers);
    ASSERT_NO_FATAL_FAILURE(open_gallery_picture(visitor, "A fish"));
    visitor.press(KeyRole::repeat);
    world.line().turn(LineTurn::to_first);
    const auto& parts = world.kiosk().visit().visitor.felt->facts.parts;
    ASSERT_FALSE(parts.empty());
    lead_hand(world, parts.front().place_W);
    world.run(1.0);
    EXPECT_EQ(world.line().page(), as_read(parts.front().name, "en"));
}

TEST(KioskLine, HA3_TheItemWithTheFocusComesAfterTheLastPage) {
    KioskWorld world;
    BlindVisitor visitor(world, 0.5, Sense::fingers);
    visitor.press(KeyRole::select);
    ASSERT_TRUE(visitor.choose("English")) << visitor.heard();
    const SpokenScreen screen = world.kiosk().screen();
    const std::string item = spoken_item(screen, *screen.focus, world.kiosk().language());
    EXPECT_TRUE(as_read(item, "en").starts_with(world.line().page())) << world.line().page();
}

/// It is told in its own language and table, so it is the same text and no further page.
TEST(KioskLine, ALanguageIsThereOnce) {
    KioskWorld world;
    BlindVisitor visitor(world, 0.5, Sense::fingers);
    visitor.press(KeyRole::select);
    world.line().press(KeyRole::down);
    world.run(0.5);
    EXPECT_TRUE(world.line().page().starts_with(as_read("Deutsch", "de"))) << world.line().page();
    EXPECT_FALSE(world.line().contents.turn(LineTurn::on, world.now_s()));
}

TEST(KioskLine, AVisitWithoutSpeechCanBeRead) {
    KioskWorld world;
    Settings settings;
    settings.is_speech_on = false;
    world.kiosk().set(settings);
    BlindVisitor visitor(world, 0.5, Sense::fingers);
    open_gallery_picture(visitor, "A fish");
}

TEST(KioskLine, ADisplayThatComesInAVisitHasWhatWasSaidLast) {
    KioskWorld world;
    BlindVisitor by_ear(world);
    by_ear.press(KeyRole::select);
    ASSERT_TRUE(by_ear.choose("English")) << by_ear.heard();
    EXPECT_TRUE(world.line().page().empty());
    world.line().is_plugged_in = true;
    world.run(0.1);
    EXPECT_TRUE(as_read(world.heard().last_text(), "en").starts_with(world.line().page()));
    EXPECT_FALSE(world.line().page().empty());
}

TEST(KioskLine, AnEndIsFeltAndAPageIsNot) {
    KioskWorld world;
    BlindVisitor visitor(world, 0.5, Sense::fingers);
    visitor.press(KeyRole::select);
    const auto patterns = [&world] { return world.servo().commands().pattern.serial; };
    const std::uint32_t before = patterns();
    world.line().turn(LineTurn::back);
    world.run(0.1);
    EXPECT_EQ(patterns(), before);
    while (world.line().contents.turn(LineTurn::on, world.now_s())) continue;
    world.line().turn(LineTurn::on);
    world.run(0.1);
    EXPECT_EQ(patterns(), before + 1);
}

TEST(KioskLine, TheGradeIsTheOperators) {
    KioskWorld world;
    EXPECT_EQ(world.line().use, BrailleUse::uncontracted);
    Settings settings;
    settings.braille = BrailleUse::contracted;
    world.kiosk().set(settings);
    EXPECT_EQ(world.line().use, BrailleUse::contracted);
}

/// The operator's keys come one after the other, without reading in between.
TEST(KioskLine, TheOperatorReadsToo) {
    KioskWorld world;
    world.line().is_plugged_in = true;
    for (const KeyRole role :
         {KeyRole::help, KeyRole::up, KeyRole::up, KeyRole::down, KeyRole::down, KeyRole::select}) {
        world.line().press(role);
        world.run(0.3);
    }
    ASSERT_TRUE(world.kiosk().is_operator_in());
    EXPECT_EQ(world.line().page(),
              as_read(world.kiosk().caption(), "en").substr(0, world.line().page().size()));
    EXPECT_FALSE(world.line().page().empty());
}

/// Whether anything that can be paged to has these words.
bool can_read(KioskWorld& world, const std::string& words) {
    while (world.line().contents.turn(LineTurn::back, world.now_s())) continue;
    std::string all = world.line().page();
    while (world.line().contents.turn(LineTurn::on, world.now_s()))
        all += ' ' + world.line().page();
    return all.find(as_read(words, "en")) != std::string::npos;
}

TEST(KioskLine, TI2_NobodyPagesBackToTheVisitorBefore) {
    KioskWorld world;
    BlindVisitor visitor(world, 0.5, Sense::fingers);
    visitor.press(KeyRole::select);
    ASSERT_TRUE(visitor.choose("English")) << visitor.heard();
    ASSERT_TRUE(visitor.choose("Finish")) << visitor.heard();
    ASSERT_TRUE(visitor.choose("Yes")) << visitor.heard();
    ASSERT_TRUE(visitor.wait_for("Goodbye")) << visitor.heard();
    EXPECT_TRUE(can_read(world, "Goodbye"));
    EXPECT_FALSE(can_read(world, "What to feel"));
    world.line().press(KeyRole::select);
    world.run(0.1);
    EXPECT_FALSE(can_read(world, "Goodbye"));
}

TEST(KioskLine, NobodyPagesBackToAPin) {
    KioskWorld world;
    world.heard().headphones = true;  // so that digits are said
    BlindVisitor staff(world, 0.2);
    world.line().is_plugged_in = true;
    open_status(staff);
    ASSERT_TRUE(world.kiosk().is_operator_in());
    EXPECT_TRUE(can_read(world, "PIN"));
    for (int i = 0; i < 4 && world.kiosk().is_operator_in(); ++i) staff.press(KeyRole::back);
    ASSERT_FALSE(world.kiosk().is_operator_in());
    EXPECT_FALSE(can_read(world, "PIN"));
}

TEST(KioskLine, AKeyThatTheSiteHasNotIsPressedAllTheSame) {
    const auto heard = std::make_shared<Heard>();
    const auto line = std::make_shared<ReadLine>();
    line->is_plugged_in = true;
    double now_s = 0.0;
    KioskParts parts;
    parts.languages = all_languages();
    parts.gallery = gallery_without_workers();
    parts.servo = std::make_unique<SteppedServo>();
    parts.sound = std::make_unique<HeardSound>(heard);
    parts.braille = std::make_unique<ReadBraille>(line);
    parts.profile = default_profile();
    parts.loader = std::make_unique<Loader>(std::make_shared<const KioskStages>(parts.profile),
                                            std::make_unique<DueJobs>(now_s));
    parts.keys = {};
    Kiosk kiosk(std::move(parts));
    for (const KeyRole role : {KeyRole::select, KeyRole::softer}) {
        line->press(role);
        now_s += 1.0;
        kiosk.step(static_cast<std::int64_t>(1e9 * now_s));
    }
    EXPECT_TRUE(is_visit_on(kiosk.visit()));
    EXPECT_EQ(heard->wanted.volume, 2U) << "3 at first";
}

}  // namespace
}  // namespace touchline
