#include "config/settings/sticks.h"

#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

namespace touchline {
namespace {

std::string error_of(std::string_view text) {
    const auto settings = parse_sticks(text, "sticks.toml");
    return settings ? "no error" : settings.error().line;
}

TEST(StickSettingsTest, TheInstalledFileMeansSticks) {
    std::ifstream in(std::string(TOUCHLINE_SOURCE_DIR) + "/config/defaults/sticks.toml");
    const std::string text(std::istreambuf_iterator<char>(in), {});
    ASSERT_FALSE(text.empty());
    const auto settings = parse_sticks(text, "sticks.toml");
    ASSERT_TRUE(settings) << settings.error().line;
    EXPECT_EQ(*settings, StickSettings{});
}

TEST(StickSettingsTest, AFolderIsAPath) {
    EXPECT_EQ(parse_sticks("watched_folder = '/srv/pictures of today'", "f")->watched_folder,
              "/srv/pictures of today");
    EXPECT_EQ(parse_sticks("", "f")->watched_folder, "");
}

TEST(StickSettingsTest, WhateverIsWrongIsOneLineWithItsPlace) {
    EXPECT_EQ(error_of("\nwatch = '/srv'"), "sticks.toml:2: 'watch' is not a setting here");
    for (const char* value : {"'pictures'", "'../x'", "1", "true", "['/srv']", R"("/a\u0000b")"}) {
        EXPECT_EQ(
            error_of(std::string("watched_folder = ") + value),
            "sticks.toml:1: 'watched_folder' must be a path that begins with /, or \"\" for none")
            << value;
    }
    const std::string line = error_of("watched_folder = ");
    EXPECT_TRUE(line.starts_with("sticks.toml:1: ")) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
}

}  // namespace
}  // namespace touchline
