// Tests touchline print as a user types it, workers and all.
#include "app/cli/options.h"
#include "app/documents/decode/files.h"
#include "tests/app/sheets/rendered_page.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <unistd.h>

namespace touchline {
namespace {

const std::string pictures = TOUCHLINE_SOURCE_DIR "/app/documents/gallery/pictures/";

class PrintCommand : public testing::Test {
  protected:
    void SetUp() override {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        folder = testing::TempDir() + "touchline-print-" + info->name() + "-" +
                 std::to_string(getpid()) + "/";
        std::filesystem::create_directories(folder);
    }

    void TearDown() override { std::filesystem::remove_all(folder); }

    int print(const std::string& input, const std::string& name,
              std::vector<std::string> options = {}) {
        std::vector<std::string> words{"print", input, "-o", folder + name};
        words.insert(words.end(), options.begin(), options.end());
        std::ostringstream out;
        std::ostringstream err;
        const int status = run_command_line(words, {}, out, err);
        said = err.str();
        EXPECT_EQ(out.str(), "");
        return status;
    }

    [[nodiscard]] bool is_empty() const { return std::filesystem::is_empty(folder); }

    std::string folder;
    std::string said;
};

TEST_F(PrintCommand, WritesEveryKindOfSheet) {
    for (const char* name : {"a.pdf", "a.svg", "a.brf", "a.ubrl", "a.index", "A.PDF"}) {
        EXPECT_EQ(print(pictures + "06-fish.svg", name), 0) << said;
        EXPECT_EQ(said, "");
        EXPECT_GT(std::filesystem::file_size(folder + name), 500U) << name;
    }
    EXPECT_EQ(read_text(folder + "a.pdf").value().substr(0, 5), "%PDF-");
    EXPECT_NE(read_text(folder + "a.brf").value().find(",A FISH"), std::string::npos);
}

TEST_F(PrintCommand, PaperLanguageGradeAndDetailAreFollowed) {
    ASSERT_EQ(print(pictures + "06-fish.svg", "a.pdf", {"--paper", "letter"}), 0) << said;
    const auto pdf = read_file(folder + "a.pdf").value();
    const PaperSize size = page_size(pdf);
    EXPECT_NEAR(std::max(size.width_mm, size.height_mm), 279.4, 0.05);
    ASSERT_EQ(print(pictures + "06-fish.svg", "en.brf"), 0);
    ASSERT_EQ(print(pictures + "06-fish.svg", "de.brf", {"--language", "de"}), 0);
    ASSERT_EQ(print(pictures + "06-fish.svg", "short.brf", {"--grade", "contracted"}), 0);
    ASSERT_EQ(print(pictures + "06-fish.svg", "less.brf", {"--detail", "1"}), 0);
    const std::string german = read_text(folder + "de.brf").value();
    EXPECT_NE(german.find("FISCH"), std::string::npos) << german;
    const auto words = [this](const char* name) {
        const std::string text = read_text(folder + name).value();
        return text.substr(0, text.find('\f')).size();
    };
    EXPECT_LT(words("short.brf"), words("en.brf"));
    EXPECT_LT(words("less.brf"), words("en.brf"));
}

TEST_F(PrintCommand, APhotographIsTracedAndNamedAfterItsFile) {
    // A ring and a disc on white, as pixels.
    std::string pnm = "P5 320 240 255\n";
    for (int y = 0; y < 240; ++y)
        for (int x = 0; x < 320; ++x) {
            const double r = std::hypot(x - 160.0, y - 120.0);
            pnm += static_cast<char>(r < 40.0 || (r > 80.0 && r < 95.0) ? 20 : 250);
        }
    std::ofstream(folder + "two rings.pgm", std::ios::binary) << pnm;
    ASSERT_EQ(print(folder + "two rings.pgm", "a.brf"), 0) << said;
    EXPECT_NE(read_text(folder + "a.brf").value().find("TWO R"), std::string::npos);
    // A hand feels that a line is closed, and where.
    EXPECT_EQ(read_text(folder + "a.brf").value().find("CLOSED"), std::string::npos);
}

TEST_F(PrintCommand, WhatCannotBeUsedIsOneLineAndNoFile) {
    std::ofstream(folder + "broken.png") << "\x89PNG\r\n\x1a\nnothing";
    for (const std::string& input : {pictures + "none.svg", folder + "broken.png", folder}) {
        EXPECT_EQ(print(input, "a.pdf"), 1);
        EXPECT_TRUE(said.starts_with("touchline: ")) << said;
        EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
        EXPECT_FALSE(std::filesystem::exists(folder + "a.pdf"));
    }
    EXPECT_EQ(print(pictures + "06-fish.svg", "nowhere/a.pdf"), 1);
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
}

/// A map of Touchline's own, by someone else.
std::string own_map(const std::string& title, const std::string& lines) {
    return R"(<svg xmlns="http://www.w3.org/2000/svg" width="116mm" height="84mm" viewBox="0 0 116 84" data-difficulty="1">)"
           "<title>" +
           title + "</title><title xml:lang=\"de\">Ein Haus</title>" + lines + "</svg>";
}

constexpr auto two_lines = R"(<path data-detail="1" d="M10 10 L100 60"><title>Track</title></path>
<path data-detail="1" d="M10 60 L100 20"><title>Road</title><title xml:lang="de">Weg</title></path>)";

TEST_F(PrintCommand, AnotherLanguageIsThatOfTheFilesOwnWords) {
    std::ofstream(folder + "map.svg") << own_map("A house", two_lines);
    ASSERT_EQ(print(folder + "map.svg", "de.brf", {"--language", "de"}), 0) << said;
    EXPECT_NE(read_text(folder + "de.brf").value().find("EIN HAUS"), std::string::npos);
    EXPECT_NE(read_text(folder + "de.brf").value().find("WEG"), std::string::npos);
    ASSERT_EQ(print(folder + "map.svg", "fr.brf", {"--language", "fr"}), 0) << said;
    EXPECT_NE(read_text(folder + "fr.brf").value().find("HOUSE"), std::string::npos);
}

TEST_F(PrintCommand, SignsThatBrailleLacksAreToldInOneLine) {
    std::ofstream(folder + "runes.svg") << own_map("ᚠᚢᚦ", two_lines);
    ASSERT_EQ(print(folder + "runes.svg", "a.pdf"), 0);
    EXPECT_NE(said.find("3 signs that the braille of the language en lacks"), std::string::npos)
        << said;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    EXPECT_EQ(print(folder + "runes.svg", "a.pdf", {"--language", "de"}), 0);
    EXPECT_EQ(said, "");
}

TEST_F(PrintCommand, MorePartsThanASheetHoldsAreOneLine) {
    std::string lines;
    for (int i = 0; i < 201; ++i)
        lines += R"(<path data-detail="1" d="M)" + std::to_string(i % 100) + " 1 v70\"><title>P" +
                 std::to_string(i) + "</title></path>";
    std::ofstream(folder + "many.svg") << own_map("Many", lines);
    for (const char* name : {"a.pdf", "a.svg", "a.brf", "a.index"}) {
        EXPECT_EQ(print(folder + "many.svg", name), 1);
        EXPECT_NE(said.find("201 parts with a name, and a sheet holds 200"), std::string::npos);
        EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    }
}

TEST_F(PrintCommand, WrongUsageIsToldBeforeAnythingIsRead) {
    for (const std::vector<std::string>& options : {std::vector<std::string>{"--paper", "a5"},
                                                    {"--language", "xx"},
                                                    {"--grade", "3"},
                                                    {"--detail", "6"},
                                                    {"--view", "none"}}) {
        EXPECT_EQ(print(pictures + "06-fish.svg", "a.pdf", options), 2);
        EXPECT_TRUE(is_empty());
    }
    EXPECT_EQ(print(pictures + "06-fish.svg", "a.png"), 2);
    EXPECT_NE(said.find(".pdf"), std::string::npos);
}

}  // namespace
}  // namespace touchline
