#include "haptics/device/serial/line_reader.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

std::vector<std::string> lines_in(LineReader& reader, const std::string& text) {
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    std::span<const std::uint8_t> left(bytes);
    std::vector<std::string> lines;
    while (const auto line = reader.next(left)) lines.emplace_back(*line);
    EXPECT_TRUE(left.empty());
    return lines;
}

TEST(LineReader, LinesEndInAnyOfTheUsualWays) {
    LineReader reader;
    EXPECT_EQ(lines_in(reader, "a\r\n\r\nb c\n\n\rd\re"),
              (std::vector<std::string>{"a", "b c", "d"}));
    EXPECT_EQ(lines_in(reader, "f\n"), std::vector<std::string>{"ef"});
}

TEST(LineReader, ALineThatIsTooLongIsDroppedWhole) {
    LineReader reader;
    EXPECT_EQ(lines_in(reader, std::string(256, 'x') + "\nb\n"), std::vector<std::string>{"b"});
    EXPECT_EQ(reader.too_long(), 1U);
    EXPECT_EQ(lines_in(reader, std::string(255, 'x') + "\n"),
              std::vector<std::string>{std::string(255, 'x')});
}

TEST(LineReader, WhatHasBegunCanBeDropped) {
    LineReader reader;
    (void)lines_in(reader, "hal");
    reader.drop();
    EXPECT_EQ(lines_in(reader, "f\nb\n"), std::vector<std::string>{"b"});
    reader.drop();
    EXPECT_EQ(lines_in(reader, "c\n"), std::vector<std::string>{"c"});
}

RC_GTEST_PROP(LineReader, PiecesDoNotMatter, ()) {
    const auto text = *rc::gen::container<std::string>(rc::gen::element('a', 'b', '\n', '\r'));
    const auto cut = *rc::gen::inRange<std::size_t>(0, text.size() + 1);
    LineReader whole, pieces;
    auto lines = lines_in(pieces, text.substr(0, cut));
    for (auto& line : lines_in(pieces, text.substr(cut))) lines.push_back(line);
    RC_ASSERT(lines == lines_in(whole, text));
}

}  // namespace
}  // namespace touchline
