// Tests our own PNM reader.
#include "tests/app/documents/decode/decoding_here.h"
#include "tests/app/documents/decode/encoders.h"

#include <string>

#include <gtest/gtest.h>

namespace touchline {
namespace {

std::vector<std::uint8_t> pixels_of(const std::string& text) {
    const auto picture = decode_picture(encoders::bytes_of(text));
    EXPECT_TRUE(picture.has_value()) << picture.error().line;
    return picture ? picture->bgr : std::vector<std::uint8_t>{};
}

TEST(PnmReader, TextWithComments) {
    EXPECT_EQ(pixels_of("P3 # colours\n2 # wide\n1\n255\n1 2 3  4 5 6"),
              (std::vector<std::uint8_t>{3, 2, 1, 6, 5, 4}));
    EXPECT_EQ(pixels_of("P1\n3 1\n101"),
              (std::vector<std::uint8_t>{0, 0, 0, 255, 255, 255, 0, 0, 0}));
}

TEST(PnmReader, SamplesAreScaledToEightBits) {
    EXPECT_EQ(pixels_of("P2 3 1 4 0 2 4"),
              (std::vector<std::uint8_t>{0, 0, 0, 128, 128, 128, 255, 255, 255}));
    EXPECT_EQ(pixels_of(std::string("P5 2 1 65535\n\x80\x00\xff\xff", 17)),
              (std::vector<std::uint8_t>{128, 128, 128, 255, 255, 255}));
}

TEST(PnmReader, WhatIsCutShortOrUnknownIsOneLine) {
    for (const char* text :
         {"P5 2 2 255\nabc", "P5 0 2 255\n", "P5 2 2 0\nabcd", "P5 2 2 65536\nabcd",
          "P2 2 2 255 1 2 3", "P2 2 2 255 1 2 3 x", "P1 2 1 12", "P4 9 1\n.",
          "P6 99999999999999999999 1 255\n", "P3 10000 4000 255\n1 2 3", "P5 "})
        EXPECT_FALSE(decode_picture(encoders::bytes_of(text)).has_value()) << text;
}

}  // namespace
}  // namespace touchline
