#include "app/documents/decode/files.h"

#include "app/documents/decode/one_line.h"
#include "tests/config/scratch_folder.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
  protected:
    [[nodiscard]] std::string path(const std::string& name) const { return folder_.path_of(name); }

    [[nodiscard]] static std::string text_in(const std::string& path) {
        const auto bytes = read_file(path);
        EXPECT_TRUE(bytes) << bytes.error().line;
        std::string text;
        for (const auto byte : bytes.value_or(std::vector<std::byte>{})) {
            text += std::to_integer<char>(byte);
        }
        return text;
    }

    [[nodiscard]] long files_in_folder() const {
        return std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator{});
    }

  private:
    ScratchFolder folder_;
};

TEST_F(Files, WhatIsWrittenReadsBackAndNothingElseIsLeft) {
    ASSERT_TRUE(write_whole_file(path("a.txt"), std::string("first")));
    ASSERT_TRUE(write_whole_file(path("a.txt"), std::string("second, over the first")));
    EXPECT_EQ(text_in(path("a.txt")), "second, over the first");
    EXPECT_EQ(files_in_folder(), 1);
    ASSERT_TRUE(write_whole_file(path("empty"), std::string()));
    EXPECT_EQ(text_in(path("empty")), "");
}

TEST_F(Files, ALinkIsFollowedAndKept) {
    ASSERT_TRUE(write_whole_file(path("real"), std::string("old")));
    fs::create_symlink(path("real"), path("link"));
    ASSERT_TRUE(write_whole_file(path("link"), std::string("new")));
    EXPECT_TRUE(fs::is_symlink(path("link")));
    EXPECT_EQ(text_in(path("real")), "new");
}

TEST_F(Files, ADeviceIsWrittenStraightAndStays) {
    ASSERT_TRUE(write_whole_file("/dev/null", std::string("gone")));
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(Files, AFailedWriteIsOneLineAndLeavesNothing) {
    const auto nowhere = write_whole_file(path("no/such/folder"), std::string("x"));
    ASSERT_FALSE(nowhere);
    EXPECT_NE(nowhere.error().line.find("No such file or directory"), std::string::npos);
    fs::create_directory(path("folder"));
    const auto over_folder = write_whole_file(path("folder"), std::string("x"));
    ASSERT_FALSE(over_folder);
    EXPECT_NE(over_folder.error().line.find("is a folder"), std::string::npos);
    EXPECT_EQ(files_in_folder(), 1);
}

TEST_F(Files, AFolderAMissingAndAnEndlessFileAreRefused) {
    EXPECT_FALSE(read_file(path("missing")));
    EXPECT_FALSE(read_file("/"));
    std::ofstream(path("large")).close();
    fs::resize_file(path("large"), max_file_bytes + 1);
    const auto large = read_file(path("large"));
    ASSERT_FALSE(large);
    EXPECT_NE(large.error().line.find("larger than 256 MiB"), std::string::npos);
}

TEST(OneLine, ControlCharactersBecomeBlanksAndLongTextsAreCutBetweenCharacters) {
    EXPECT_EQ(one_line("a\nb\tc\x7f"), "a b c ");
    EXPECT_EQ(one_line("f\xc3\xbcnf"), "f\xc3\xbcnf");
    std::string umlauts;
    for (int i = 0; i < 150; ++i) umlauts += "\xc3\xbc";
    EXPECT_EQ(one_line("x" + umlauts), "x" + umlauts.substr(0, 198) + "...");
    EXPECT_EQ(one_line(""), "");
}

}  // namespace
}  // namespace touchline
