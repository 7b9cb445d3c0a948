#include "config/settings/stand.h"

#include <gtest/gtest.h>

namespace touchline {
namespace {

StandSettings sample() {
    return {1600,
            1200,
            {100.25, 90.125, 1500.1, 95.3, 1490.7, 1100.9, 110.0, 1095.0 / 7},
            320.0,
            230.0};
}

TEST(StandSettingsTest, TextAndBackAreTheSameBits) {
    const auto read = parse_stand(stand_text(sample()), "stand.toml");
    ASSERT_TRUE(read) << read.error().line;
    EXPECT_EQ(*read, sample());
}

TEST(StandSettingsTest, WhateverIsWrongIsOneLineWithItsPlace) {
    const std::string right = stand_text(sample());
    const auto line_of = [](const std::string& text) {
        const auto read = parse_stand(text, "stand.toml");
        return read ? "" : read.error().line;
    };
    EXPECT_EQ(line_of("x = 1\n" + right), "stand.toml:1: 'x' is not a setting here");
    std::string wide = right;
    wide.replace(wide.find("320"), 3, "9999");
    EXPECT_NE(line_of(wide).find("'bed_width_mm' must be a number from 50 to 2000"),
              std::string::npos);
    std::string short_list = right;
    short_list.replace(short_list.find("100.25, "), 8, "");
    EXPECT_NE(line_of(short_list).find("'bed_corners_px' must be eight places in the picture"),
              std::string::npos);
    for (const char* text : {"", "nonsense", "bed_corners_px = 1", "bed_corners_px = ['a']"}) {
        const std::string line = line_of(text);
        EXPECT_EQ(line.find("stand.toml:"), 0U) << line;
        EXPECT_EQ(line.find('\n'), std::string::npos);
    }
}

}  // namespace
}  // namespace touchline
