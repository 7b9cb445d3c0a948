// Tests what is said of a file or a stick that a visitor brought, from its bytes through the
// workers to the words: why it cannot be felt, in every language, and whether there is a thing
// under the hand.
#include "app/documents/sticks/spoken_name.h"
#include "app/documents/trace/finding_things.h"
#include "app/visit/told_lines.h"
#include "tests/app/kiosk/blind_visitor.h"
#include "tests/app/kiosk/kiosk_world.h"

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

struct BadFile {
    const char* name;
    std::string bytes;
    const char* told;  // in English
};

/// A drawing of `size` that is all white.
std::string white_picture(const std::string& size, std::size_t pixels) {
    return "P5 " + size + " 255\n" + std::string(pixels, '\xff');
}

std::string half_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    return bytes.substr(0, bytes.size() / 2);
}

std::vector<BadFile> bad_files() {
    return {{"broken.png", half_of(TOUCHLINE_SOURCE_DIR "/tests/app/kiosk/triangle.png"),
             "The file is damaged. Copy it again, or choose another one."},
            {"empty.png", "", "The file is empty. Copy it again, or choose another one."},
            {"huge.pgm", "P5 30000 30000 255\n12345",
             "The picture is too large. Save it smaller and bring it again."},
            {"nothing.pgm", white_picture("64 64", 4096),
             "Nothing in the picture stands out. Choose one with more contrast."},
            {"speck.pgm", white_picture("4 4", 16),
             "The picture is too small to be felt. Bring a larger one."},
            {"text.png", "no picture",
             "This file is not a picture that can be felt. Use a PNG, JPEG or PDF file."},
            {"wrong.svg", "<svg viewBox='0 0 9 9'><path d='M0 0",
             "The file is damaged. Copy it again, or choose another one."}};
}

/// The parameter is an index into all_languages().
class ToldReasons : public testing::TestWithParam<std::size_t> {
  protected:
    void begin() {
        visitor.press(KeyRole::select);
        ASSERT_TRUE(visitor.choose(all_languages()[GetParam()].name())) << visitor.heard();
    }

    [[nodiscard]] const Language& language() { return world.kiosk().language(); }

    [[nodiscard]] std::string words(const char* context, std::string_view english) {
        return language().text(context, std::string(english));
    }

    KioskWorld world;
    BlindVisitor visitor{world};
};

TEST_P(ToldReasons, OfAFileAreItsNameAndItsOwnSentence) {
    std::vector<fs::path> paths;
    for (const BadFile& file : bad_files()) {
        paths.push_back(world.folder() / file.name);
        std::ofstream(paths.back(), std::ios::binary) << file.bytes;
    }
    begin();
    world.put_stick(paths);
    for (const BadFile& file : bad_files()) {
        SCOPED_TRACE(file.name);
        while (open_screen(world.kiosk().visit()) != VisitScreen::choose)
            visitor.press(KeyRole::back);
        ASSERT_TRUE(visitor.choose(words("visit", "Your USB stick"))) << visitor.heard();
        ASSERT_TRUE(visitor.choose_picture(spoken_name(file.name, language()))) << visitor.heard();
        const std::string named =
            language().text("visit", "{0} cannot be opened.", {spoken_name(file.name, language())});
        EXPECT_TRUE(visitor.wait_for(named + ' ' + words("trouble", file.told))) << visitor.heard();
        visitor.press(KeyRole::select);  // "Go on", back to the list
    }
}

TEST_P(ToldReasons, OfAStickWithNothingToFeelAreThatThereIsNothing) {
    begin();
    const auto before = world.heard().things.size();
    std::ofstream(world.folder() / "notes.xyz") << "nothing to feel";
    world.put_stick({world.folder() / "notes.xyz"});
    const std::string told = nothing_words({}, language());
    EXPECT_TRUE(world.heard().was_said(told, before)) << world.heard().text_since(before);
    EXPECT_EQ(told == nothing_words({}, Language()), language().code() == "en");
    EXPECT_FALSE(world.heard().was_said(words("trouble", stick_trouble), before));
}

INSTANTIATE_TEST_SUITE_P(All, ToldReasons, testing::Range<std::size_t>(0, all_languages().size()),
                         [](const auto& tested) { return all_languages()[tested.param].code(); });

/// Writes a PPM file: a dark disc with light and grain everywhere, as no program paints it.
void write_photograph(const std::filesystem::path& file) {
    constexpr int width = 420;
    constexpr int height = 300;
    std::ofstream out(file, std::ios::binary);
    out << "P6 " << width << ' ' << height << " 255\n";
    std::uint32_t random = 1;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            random = random * 1664525U + 1013904223U;
            const double grain = static_cast<double>(random >> 24U) / 16.0 - 8.0;
            const double light = 60.0 * std::sin(x / 17.0) * std::cos(y / 23.0);
            const double ground = std::hypot(x - 210, y - 150) < 70.0 ? 80.0 : 160.0;
            const double value =
                ground + 0.5 * light + 15.0 * std::sin((x + 2.0 * y) / 41.0) + grain;
            const char level = static_cast<char>(static_cast<unsigned char>(value));
            out.put(level).put(level).put(level);
        }
    }
}

/// For a place, it returns nothing at first, then a failure, then the middle of the picture.
ThingFinder made_up_finder(std::shared_ptr<int> looks) {
    return [looks](const Page& page,
                   const std::optional<PlaceInPicture>& place) -> Result<std::optional<Page>> {
        if (!place) {
            Page seen = page;
            seen.was_searched = true;
            return seen;
        }
        if (++*looks == 1) return std::nullopt;
        if (*looks == 2) return failure("the network is damaged");
        MainThings thing;
        thing.mask = {20, 20, std::vector<std::uint8_t>(400, 0)};
        for (std::size_t y = 5; y < 15; ++y)
            for (std::size_t x = 5; x < 15; ++x) thing.mask.grey[20 * y + x] = 255;
        thing.boxes = {{0.25, 0.25, 0.75, 0.75}};
        return with_further_thing(page, std::move(thing));
    };
}

TEST(ThingHere, IsSaidWhetherItWasFoundOrNotAndThePictureStays) {
    const auto looks = std::make_shared<int>(0);
    KioskWorld world(false, whole_gallery(all_languages()), made_up_finder(looks));
    BlindVisitor visitor(world);
    const std::filesystem::path photograph = world.folder() / "garden.ppm";
    write_photograph(photograph);
    world.put_stick({photograph});
    visitor.press(KeyRole::select);
    ASSERT_TRUE(visitor.choose("English"));
    ASSERT_TRUE(visitor.choose("Your USB stick"));
    ASSERT_TRUE(visitor.choose("garden")) << visitor.heard();
    ASSERT_TRUE(visitor.wait_for("It has no clear main subject")) << visitor.heard();
    (void)world.kiosk().take_report();

    ASSERT_TRUE(visitor.choose("Find the thing under my hand")) << visitor.heard();
    ASSERT_TRUE(visitor.wait_for("Nothing clear was found there")) << visitor.heard();
    EXPECT_EQ(world.kiosk().take_report(), "") << "that is an answer, no trouble";

    ASSERT_TRUE(visitor.choose("Find the thing under my hand")) << visitor.heard();
    ASSERT_TRUE(visitor.wait_for("The main subject cannot be looked for now")) << visitor.heard();
    EXPECT_NE(world.kiosk().take_report(), "");

    const int felt = world.servo().felt_count;
    ASSERT_TRUE(visitor.choose("Find the thing under my hand")) << visitor.heard();
    ASSERT_TRUE(visitor.wait_for("Only the main subject of the photograph")) << visitor.heard();
    EXPECT_GT(world.servo().felt_count, felt);
    ASSERT_TRUE(visitor.choose("How much of the photo")) << visitor.heard();
    ASSERT_TRUE(visitor.choose("The whole photograph")) << visitor.heard();
    EXPECT_EQ(*looks, 3);
}

/// The file has the title "A house".
TEST(BroughtPictures, HaveOneNameWhereverItIsHeard) {
    KioskWorld world;
    BlindVisitor visitor(world);
    world.put_stick({TOUCHLINE_SOURCE_DIR "/app/documents/gallery/pictures/07-house.svg"});
    visitor.press(KeyRole::select);
    ASSERT_TRUE(visitor.choose("English"));
    ASSERT_TRUE(visitor.choose("Your USB stick"));
    ASSERT_TRUE(visitor.choose("07 house"));
    ASSERT_TRUE(visitor.wait_for("07 house. A house. It is small")) << visitor.heard();
    EXPECT_EQ(world.kiosk().screen().title, "07 house");
    visitor.press(KeyRole::back);
    ASSERT_EQ(open_screen(world.kiosk().visit()), VisitScreen::choose);
    EXPECT_EQ(world.kiosk().screen().items.front().value, "07 house");
}

}  // namespace
}  // namespace touchline
