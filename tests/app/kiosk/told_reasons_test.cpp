// Tests why a visitor's file or stick cannot be felt, from its bytes through the workers to what is
// said, in every language.
#include "app/session/told_lines.h"
#include "app/sticks/spoken_name.h"
#include "app/sticks/stick_words.h"
#include "tests/app/kiosk/blind_visitor.h"
#include "tests/app/kiosk/kiosk_world.h"

#include <filesystem>
#include <fstream>
#include <iterator>
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
            {"letter.docx", "PK", "Office files cannot be felt. Please bring the file as a PDF."},
            {"nothing.pgm", white_picture("64 64", 4096),
             "Nothing in the picture stands out. Choose one with more contrast."},
            {"speck.pgm", white_picture("4 4", 16),
             "The picture is too small to be felt. Bring a larger one."},
            {"text.png", "no picture",
             "This file is no picture that can be felt. Bring a PNG, JPEG or PDF."},
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

TEST_P(ToldReasons, OfAFileAreItsOwnSentence) {
    std::vector<fs::path> paths;
    for (const BadFile& file : bad_files()) {
        paths.push_back(world.folder() / file.name);
        std::ofstream(paths.back(), std::ios::binary) << file.bytes;
    }
    begin();
    world.put_stick(paths);
    ASSERT_TRUE(visitor.choose(words("visit", "Your USB stick"))) << visitor.heard();
    for (const BadFile& file : bad_files()) {
        SCOPED_TRACE(file.name);
        ASSERT_TRUE(visitor.choose(spoken_name(file.name, language()))) << visitor.heard();
        EXPECT_TRUE(visitor.wait_for(words("trouble", file.told))) << visitor.heard();
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

}  // namespace
}  // namespace touchline
