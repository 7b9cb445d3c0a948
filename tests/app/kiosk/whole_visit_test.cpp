// Tests whole visits: by ears or fingers alone, slowly, with two switches, in every language,
// rudely.
#include "app/documents/gallery/gallery.h"
#include "tests/app/documents/decode/files_of_formats.h"
#include "tests/app/kiosk/blind_visitor.h"
#include "tests/app/kiosk/kiosk_world.h"

#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <random>

#include <gtest/gtest.h>
#include <unistd.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

const fs::path pictures = TOUCHLINE_SOURCE_DIR "/app/documents/gallery/pictures";

/// Moves the hand along each outline of what is felt and returns the share of the length that was
/// felt: the handle within 2 mm of the outline while the outline held the hand.
double traced_share(KioskWorld& world) {
    const auto map = world.servo().picture().map;
    double length_m = 0.0;
    double felt_m = 0.0;
    for (const Outline& outline : map->outlines) {
        const std::size_t count = outline.points.size() + (outline.is_closed ? 1 : 0);
        for (std::size_t i = 1; i < count; ++i) {
            const Position a = outline.points[i - 1];
            const Position b = outline.points[i % outline.points.size()];
            const double part_m = norm(b - a);
            world.servo().hand().move_to(b);
            world.run(part_m / 0.08);
            length_m += part_m;
            const HandState& hand = world.kiosk().hand();
            if (hand.outline >= 0 && norm(hand.p_WH - b) < 0.002) felt_m += part_m;
        }
    }
    return length_m > 0.0 ? felt_m / length_m : 0.0;
}

/// Goes from the attract screen to the screen of choices, in English.
void begin(BlindVisitor& visitor) {
    visitor.press(KeyRole::select);
    ASSERT_TRUE(visitor.choose("English")) << visitor.heard();
    ASSERT_TRUE(visitor.wait_for("What to feel")) << visitor.heard();
}

void to_choices(BlindVisitor& visitor, const std::string& title = "What to feel") {
    for (int i = 0; i < 4; ++i) {
        visitor.press(KeyRole::back);
        if (visitor.has_heard(title)) return;
    }
    FAIL() << visitor.heard();
}

void finish(KioskWorld& world, BlindVisitor& visitor) {
    to_choices(visitor);
    ASSERT_TRUE(visitor.choose("Finish")) << visitor.heard();
    ASSERT_TRUE(visitor.choose("Yes")) << visitor.heard();
    ASSERT_TRUE(visitor.wait_for("Goodbye")) << visitor.heard();
    world.run(30.0);
    EXPECT_FALSE(is_visit_on(world.kiosk().visit()));
}

void feel_gallery_picture(KioskWorld& world, BlindVisitor& visitor) {
    ASSERT_TRUE(visitor.choose("Gallery")) << visitor.heard();
    ASSERT_TRUE(visitor.choose_picture("A heart")) << visitor.heard();
    ASSERT_TRUE(visitor.wait_for("Guide me along the")) << visitor.heard();
    EXPECT_GT(traced_share(world), 0.9);
}

/// Who hears alone, and who reads the braille line alone: neither sound nor screen is of use.
class WholeVisitBy : public testing::TestWithParam<Sense> {};

INSTANTIATE_TEST_SUITE_P(HA3, WholeVisitBy, testing::Values(Sense::ears, Sense::fingers),
                         [](const auto& sense) {
                             return sense.param == Sense::ears ? "ears" : "fingers";
                         });

TEST_P(WholeVisitBy, TheWordsAloneToThreePictures) {
    KioskWorld world;
    BlindVisitor visitor(world, 0.5, GetParam());
    begin(visitor);
    feel_gallery_picture(world, visitor);

    world.put_stick({pictures / "07-house.svg"});
    to_choices(visitor);
    ASSERT_TRUE(visitor.choose("Your USB stick")) << visitor.heard();
    ASSERT_TRUE(visitor.choose("07 house")) << visitor.heard();
    ASSERT_TRUE(visitor.wait_for("Guide me along the")) << visitor.heard();
    EXPECT_GT(traced_share(world), 0.9);

    world.lay(TOUCHLINE_SOURCE_DIR "/tests/app/kiosk/triangle.png");
    to_choices(visitor);
    ASSERT_TRUE(visitor.choose("Camera")) << visitor.heard();
    ASSERT_TRUE(visitor.choose("Take the photo")) << visitor.heard();
    ASSERT_TRUE(visitor.wait_for("Guide me along the")) << visitor.heard();
    EXPECT_GT(traced_share(world), 0.9);

    EXPECT_LE(visitor.slowest_answer_s(), 0.3);
    finish(world, visitor);
}

/// A key every 25 s and an idle handle: a visitor who answers is never sent away.
TEST_P(WholeVisitBy, SlowlyAndWithTheHandleIdle) {
    KioskWorld world;
    BlindVisitor visitor(world, 25.0, GetParam());
    begin(visitor);
    ASSERT_TRUE(visitor.choose("Practice shape")) << visitor.heard();
    EXPECT_GT(world.servo().felt_count, 0);
    EXPECT_TRUE(is_visit_on(world.kiosk().visit()));
    EXPECT_LE(visitor.slowest_answer_s(), 0.3);
}

/// Captions show all that was said, and the handle asks for attention before time runs out.
TEST(WholeVisit, DeafByCaptionsAndTheHandle) {
    KioskWorld world;
    BlindVisitor visitor(world);
    visitor.press(KeyRole::select);
    for (int i = 0; i < 40; ++i) {
        visitor.press(i % 5 == 4 ? KeyRole::select : KeyRole::down);
        EXPECT_EQ(world.kiosk().visit().visitor.caption.text, world.heard().last_text());
        if (!is_visit_on(world.kiosk().visit())) break;
    }
    const std::uint32_t patterns = world.servo().commands().pattern.serial;
    EXPECT_GT(patterns, 0U) << "a focus that moves is felt";
    world.run(100.0);
    EXPECT_EQ(open_screen(world.kiosk().visit()), VisitScreen::question);
    EXPECT_GT(world.servo().commands().pattern.serial, patterns) << "so is the question";
    EXPECT_LE(world.servo().most_force_N, 3.0);
}

TEST_P(WholeVisitBy, InEveryLanguage) {
    for (const Language& language : all_languages()) {
        SCOPED_TRACE(language.name());
        KioskWorld world;
        BlindVisitor visitor(world, 0.5, GetParam());
        visitor.press(KeyRole::select);
        ASSERT_TRUE(visitor.choose(language.name())) << visitor.heard();
        const std::string code = world.kiosk().language().code();
        EXPECT_EQ(code, language.code());
        const auto since = world.heard().things.size();
        for (int i = 0; i < 6; ++i) visitor.press(KeyRole::down);
        for (std::size_t i = since; i < world.heard().things.size(); ++i) {
            const HeardThing& thing = world.heard().things[i];
            EXPECT_TRUE(thing.text.empty() || thing.language == code) << thing.text;
        }
    }
}

/// The title of a picture that ships with the kiosk.
std::string title_of(const std::string& ending, const Language& language) {
    const std::vector<GalleryEntry> entries = list_gallery(pictures, {language.code()}).value();
    for (const GalleryEntry& entry : entries)
        if (entry.path.ends_with(ending)) return entry.title;
    return {};
}

TEST_P(WholeVisitBy, PracticeAndGalleryAreInTheVisitorsLanguage) {
    for (const Language& language : all_languages()) {
        SCOPED_TRACE(language.name());
        const auto words = [&language](const char* english) {
            return language.text("visit", english);
        };
        KioskWorld world;
        BlindVisitor visitor(world, 0.5, GetParam());
        visitor.press(KeyRole::select);
        ASSERT_TRUE(visitor.choose(language.name())) << visitor.heard();
        ASSERT_TRUE(visitor.choose(words("Practice shape"))) << visitor.heard();
        EXPECT_TRUE(visitor.wait_for(title_of("-circle.svg", language))) << visitor.heard();
        ASSERT_TRUE(visitor.choose(words("Another shape"))) << visitor.heard();
        EXPECT_TRUE(visitor.wait_for(title_of("-square.svg", language))) << visitor.heard();
        to_choices(visitor, words("What to feel"));
        ASSERT_TRUE(visitor.choose(words("Gallery"))) << visitor.heard();
        const std::string heart = title_of("-heart.svg", language);
        ASSERT_TRUE(visitor.choose_picture(heart)) << visitor.heard();
        EXPECT_TRUE(visitor.wait_for(heart + ". ")) << visitor.heard();
    }
}

/// Uses two keys only: one moves on, the other selects.
TEST(WholeVisit, WithTwoSwitches) {
    KioskWorld world;
    Settings settings;
    settings.two_switches = SwitchUse::move_and_select;
    world.kiosk().set(settings);
    const auto move_to = [&world](const std::string& item) {
        for (int i = 0; i < 80; ++i) {
            const auto since = world.heard().things.size();
            world.press(KeyRole::down);
            world.run(0.5);
            if (("\n" + world.heard().text_since(since)).find("\n" + item) != std::string::npos)
                return true;
        }
        return false;
    };
    const auto select = [&world] {
        world.press(KeyRole::select);
        world.run(1.0);
    };
    select();
    ASSERT_TRUE(move_to("English, 1"));
    select();
    ASSERT_TRUE(move_to("Gallery"));
    select();
    ASSERT_TRUE(move_to("very easy"));
    select();
    ASSERT_TRUE(move_to("A heart"));
    select();
    for (int i = 0; i < 40 && world.servo().picture().map == nullptr; ++i) world.run(0.25);
    ASSERT_NE(world.servo().picture().map, nullptr);
    EXPECT_FALSE(world.servo().picture().map->outlines.empty());
    ASSERT_TRUE(move_to("Back")) << "keys are items too";
    select();
    ASSERT_TRUE(move_to("Repeat"));
    EXPECT_EQ(world.kiosk().caption(), "Repeat") << "who cannot hear reads which key is next";
    select();
    EXPECT_NE(world.kiosk().caption(), "Repeat");
    EXPECT_TRUE(is_visit_on(world.kiosk().visit()));
}

bool is_on_screen(KioskWorld& world, VisitItem item) {
    return place_of(world.kiosk().screen().items, static_cast<int>(item)).has_value();
}

/// Waits until the item comes by itself, and presses the only switch.
bool choose_when_it_comes(KioskWorld& world, VisitItem item) {
    for (int i = 0; i < 400; ++i) {
        const SpokenScreen now = world.kiosk().screen();
        if (now.focus && now.items[*now.focus].id == static_cast<int>(item)) {
            world.press(KeyRole::select);
            world.run(1.0);
            return true;
        }
        world.run(0.25);
    }
    return false;
}

/// One switch alone: every item comes by itself, and the handle that leads is not stopped by it.
TEST(WholeVisit, WithOneSwitch) {
    KioskWorld world;
    Settings settings;
    settings.two_switches = SwitchUse::by_itself;
    world.kiosk().set(settings);
    const auto before = world.heard().things.size();
    world.run(60.0);
    EXPECT_FALSE(world.heard().was_said("Repeat", before)) << "nobody is here to be told of keys";
    world.press(KeyRole::select);
    world.run(0.1);
    for (const VisitItem item : {VisitItem::entry, VisitItem::practise, VisitItem::lead_round})
        ASSERT_TRUE(choose_when_it_comes(world, item)) << world.heard().text_since(before);
    const auto led = world.heard().things.size();
    world.run(20.0);
    EXPECT_FALSE(world.heard().was_said("Stopped.", led)) << world.heard().text_since(led);
    if (world.kiosk().visit().visitor.leading) world.press(KeyRole::select);
    while (!is_on_screen(world, VisitItem::finish))
        ASSERT_TRUE(choose_when_it_comes(world, VisitItem::back));
    for (const VisitItem item : {VisitItem::finish, VisitItem::yes})
        ASSERT_TRUE(choose_when_it_comes(world, item)) << world.heard().text_since(led);
    EXPECT_TRUE(world.heard().was_said("Goodbye", led));
}

TEST_P(WholeVisitBy, ThroughAPdfOfManyPages) {
    constexpr int pages = 12;
    KioskWorld world;
    const encoders::Bytes pdf =
        drawn_pdf(std::vector<std::vector<DrawnImage>>(pages, {{100.0, 100.0, 300.0, 300.0}}));
    std::ofstream(world.folder() / "tales.pdf", std::ios::binary)
        .write(reinterpret_cast<const char*>(pdf.data()), static_cast<std::streamsize>(pdf.size()));
    world.put_stick({world.folder() / "tales.pdf"});
    BlindVisitor visitor(world, 0.5, GetParam());
    begin(visitor);
    ASSERT_TRUE(visitor.choose("Your USB stick, 1 picture")) << visitor.heard();
    ASSERT_TRUE(visitor.choose("tales")) << visitor.heard();
    ASSERT_TRUE(visitor.wait_for("Page 1 of 12")) << visitor.heard();
    ASSERT_TRUE(visitor.choose("Pages")) << visitor.heard();
    for (int number = 2; number <= pages; ++number) {
        ASSERT_TRUE(visitor.choose("Go to the next page")) << visitor.heard();
        ASSERT_TRUE(visitor.wait_for("Page " + std::to_string(number) + " of 12"))
            << visitor.heard();
        EXPECT_FALSE(world.servo().picture().map->outlines.empty()) << number;
    }
    EXPECT_FALSE(visitor.find("Go to the next page")) << "it is the last";
    ASSERT_TRUE(visitor.choose("Go to the previous page")) << visitor.heard();
    ASSERT_TRUE(visitor.wait_for("Page 11 of 12")) << visitor.heard();
    finish(world, visitor);
}

TEST_P(WholeVisitBy, ResetAndStartOver) {
    KioskWorld world;
    BlindVisitor visitor(world, 0.5, GetParam());
    begin(visitor);
    feel_gallery_picture(world, visitor);
    to_choices(visitor);
    ASSERT_TRUE(visitor.choose("Settings")) << visitor.heard();
    ASSERT_TRUE(visitor.choose("Speaking speed")) << visitor.heard();
    ASSERT_TRUE(visitor.choose("Step 1")) << visitor.heard();
    const std::size_t rate = world.heard().wanted.rate;
    ASSERT_TRUE(visitor.choose("Reset the settings")) << visitor.heard();
    ASSERT_TRUE(visitor.choose("Yes")) << visitor.heard();
    EXPECT_NE(world.heard().wanted.rate, rate);
    EXPECT_FALSE(world.servo().picture().map->outlines.empty()) << "the picture stays";
    ASSERT_TRUE(visitor.choose("Start over")) << visitor.heard();
    ASSERT_TRUE(visitor.choose("No")) << visitor.heard();
    EXPECT_FALSE(world.servo().picture().map->outlines.empty());
    ASSERT_TRUE(visitor.choose("Start over")) << visitor.heard();
    ASSERT_TRUE(visitor.choose("Yes")) << visitor.heard();
    EXPECT_TRUE(visitor.has_heard("Pictures to feel")) << visitor.heard();
    EXPECT_TRUE(world.servo().picture().map->outlines.empty()) << "nothing stays";
    ASSERT_TRUE(visitor.choose("English")) << visitor.heard();
    ASSERT_TRUE(visitor.wait_for("What to feel")) << visitor.heard();
}

/// Presses 10 000 seeded random keys, in any order and at any pace.
TEST(WholeVisit, RudelyItIsNeverStuckAndEveryKeyIsAnswered) {
    KioskWorld world;
    Settings settings;
    settings.double_strike_s = 0.0;  // every press counts
    world.kiosk().set(settings);
    std::mt19937 random(2026);
    double silent_s = 0.0;
    for (int i = 0; i < 10'000; ++i) {
        const auto before = world.heard().things.size();
        const double pressed_s = world.now_s();
        world.kiosk().press(static_cast<KeyRole>(random() % key_role_count));
        world.run(random() % 8 == 0 ? 0.4 : 0.02);
        ASSERT_GT(world.heard().things.size(), before) << "key " << i;
        ASSERT_LE(world.heard().things[before].at_s - pressed_s, 0.3) << "key " << i;
        silent_s = std::max(silent_s, world.heard().things[before].at_s - pressed_s);
        if (i % 1000 == 0) world.heard().things.clear();
    }
    // Back leads to the choices from anywhere, and on from there.
    for (int i = 0; i < 12; ++i) {
        world.press(KeyRole::back);
        world.run(1.0);
    }
    BlindVisitor visitor(world);
    EXPECT_LE(silent_s, 0.3);
    world.run(400.0);  // the visitor has left
    EXPECT_FALSE(is_visit_on(world.kiosk().visit()));
    begin(visitor);
}

/// Returns every file below a folder with its contents.
std::map<fs::path, std::string> files_below(const fs::path& folder) {
    std::map<fs::path, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file()) continue;
        std::ifstream file(entry.path(), std::ios::binary);
        files[entry.path()] = {std::istreambuf_iterator<char>(file), {}};
    }
    return files;
}

TEST_P(WholeVisitBy, TI4_NothingOfAVisitorIsInAnyFileAfterwards) {
    KioskWorld world;
    const fs::path home = fs::path(testing::TempDir()) / ("home-" + std::to_string(getpid()));
    fs::remove_all(home);
    fs::create_directories(home);
    for (const char* name : {"HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME",
                             "XDG_DATA_HOME", "TMPDIR", "TOUCHLINE_RECORDINGS"})
        setenv(name, home.c_str(), 1);
    world.put_stick({pictures / "07-house.svg"});
    const auto before = files_below(world.folder() / "stick");
    BlindVisitor visitor(world, 0.5, GetParam());
    begin(visitor);
    ASSERT_TRUE(visitor.choose("Your USB stick")) << visitor.heard();
    ASSERT_TRUE(visitor.choose("07 house")) << visitor.heard();
    ASSERT_TRUE(visitor.wait_for("Guide me along the")) << visitor.heard();
    finish(world, visitor);
    EXPECT_EQ(files_below(world.folder() / "stick"), before) << "the stick is as it was";
    for (const auto& [file, text] : files_below(world.folder() / "site")) {
        EXPECT_EQ(file.filename(), "counters.csv") << "nothing else is written";
        EXPECT_EQ(text.find("house"), std::string::npos);
    }
    EXPECT_TRUE(files_below(home).empty());
    EXPECT_EQ(world.heard().forgotten, 1);
    EXPECT_EQ(world.line().forgotten, 3) << "before the visit, with it and after goodbye";
    EXPECT_TRUE(world.servo().picture().map->outlines.empty()) << "nor does the servo have it";
    EXPECT_EQ(world.servo().recordings_forgotten, 1) << "nor how it was felt";
    EXPECT_EQ(world.servo().recordings_kept, 0);
    EXPECT_EQ(world.kiosk().visit().visitor.stick_list, nullptr);
    fs::remove_all(home);
}

}  // namespace
}  // namespace touchline
