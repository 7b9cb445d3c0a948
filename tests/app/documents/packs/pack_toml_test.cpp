// Tests what pack.toml may hold, and which line refuses the rest.
#include "app/documents/packs/pack.h"
#include "audio-cues/words/language.h"

#include <gtest/gtest.h>

namespace touchline {
namespace {

const std::string good = R"(id = "fish-1"
title = { en = "Fish", de = "Fische" }
author = "Ann"
licence = "CC0-1.0"
version = "1.2"
languages = ["en", "pt-BR"]

[[picture]]
file = "fish.svg"
difficulty = 3

[[picture]]
file = "more/whale.svg"

[[sound]]
file = "fish.ogg"
picture = "fish.svg"
language = "en"
says = "title"

[[sound]]
file = "fin.wav"
picture = "fish.svg"
language = "en"
part = "fin"
)";

std::string changed(const std::string& from, const std::string& to) {
    std::string text = good;
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

TEST(PackToml, SaysWhatIsInThePack) {
    const auto info = pack_info_of(good);
    ASSERT_TRUE(info.has_value()) << sentence_of(info.error(), Language());
    EXPECT_EQ(info->id, "fish-1");
    EXPECT_EQ(title_in(*info, "de"), "Fische");
    EXPECT_EQ(title_in(*info, "xx"), info->title.front().text);
    EXPECT_EQ(info->version, (PackVersion{1, 2, 0}));
    EXPECT_EQ(info->languages, (std::vector<std::string>{"en", "pt-BR"}));
    ASSERT_EQ(info->pictures.size(), 2U);
    EXPECT_EQ(info->pictures[0].difficulty, 3);
    EXPECT_EQ(info->pictures[1].difficulty, std::nullopt);
    ASSERT_EQ(info->sounds.size(), 2U);
    EXPECT_EQ(info->sounds[0].says, SoundText::title);
    EXPECT_EQ(info->sounds[1].says, SoundText::part);
    EXPECT_EQ(info->sounds[1].part, "fin");
}

TEST(PackToml, WrittenAndReadIsTheSame) {
    const auto info = pack_info_of(good);
    ASSERT_TRUE(info.has_value());
    const auto back = pack_info_of(toml_of(*info));
    ASSERT_TRUE(back.has_value()) << sentence_of(back.error(), Language()) << toml_of(*info);
    EXPECT_TRUE(*back == *info);
}

struct Wrong {
    const char* from;
    const char* to;
    FindingKind kind;
    int line;
};

TEST(PackToml, WhatIsWrongIsToldWithItsLine) {
    const Wrong wrongs[]{
        {"fish-1", "Fish 1", FindingKind::toml_value, 1},
        {"fish-1", "../x", FindingKind::toml_value, 1},
        {"author = \"Ann\"\n", "", FindingKind::toml_missing, 1},
        {"author = \"Ann\"", "author = 7", FindingKind::toml_value, 3},
        {"author = \"Ann\"", "autor = \"Ann\"", FindingKind::toml_unknown, 3},
        {"author = \"Ann\"", "author = \"Ann", FindingKind::toml_syntax, 3},
        {"author = \"Ann\"", "author = \"A\\u202En\"", FindingKind::toml_value, 3},
        {"\"1.2\"", "\"1.2.3.4\"", FindingKind::toml_value, 5},
        {"\"1.2\"", "\"-1\"", FindingKind::toml_value, 5},
        {"\"1.2\"", "\"99999\"", FindingKind::toml_value, 5},
        {"\"pt-BR\"", "\"en\"", FindingKind::toml_value, 6},
        {"\"pt-BR\"", "\"--\"", FindingKind::toml_value, 6},
        {"[\"en\", \"pt-BR\"]", "[]", FindingKind::toml_value, 6},
        {"\"fish.svg\"\ndiff", "\"../fish.svg\"\ndiff", FindingKind::toml_value, 9},
        {"\"fish.svg\"\ndiff", "\"fish.png\"\ndiff", FindingKind::toml_value, 9},
        {"difficulty = 3", "difficulty = 6", FindingKind::toml_value, 10},
        {"more/whale.svg", "fish.svg", FindingKind::toml_value, 0},
        {"picture = \"fish.svg\"", "picture = \"cow.svg\"", FindingKind::not_in_pack, 0},
        {"says = \"title\"", "says = \"all\"", FindingKind::toml_value, 19},
        {"says = \"title\"\n", "", FindingKind::toml_missing, 15},
    };
    for (const Wrong& wrong : wrongs) {
        const auto info = pack_info_of(changed(wrong.from, wrong.to));
        ASSERT_FALSE(info.has_value()) << wrong.to;
        EXPECT_EQ(static_cast<int>(info.error().kind), static_cast<int>(wrong.kind)) << wrong.to;
        EXPECT_EQ(info.error().line, wrong.line) << wrong.to;
        EXPECT_EQ(info.error().file, "pack.toml");
    }
}

TEST(PackToml, LanguageTagsAreToldApart) {
    for (const char* tag : {"en", "de-AT", "zh-Hant-TW", "gsw"}) EXPECT_TRUE(is_language_tag(tag));
    for (const char* tag : {"", "e", "engl", "en-", "en_US", "-en", "en-123456789", "../en", "e1"})
        EXPECT_FALSE(is_language_tag(tag)) << tag;
}

/// Every kind has words, and what a pack names stays on their one line.
TEST(PackFinding, OneIsAWord) {
    const auto told = [](double megabytes) {
        return sentence_of({FindingKind::file_too_large, "", 0, "", megabytes}, Language());
    };
    EXPECT_EQ(told(1.0), "this is larger than one megabyte; save it smaller");
    EXPECT_EQ(told(16.0), "this is larger than 16 megabytes; save it smaller");
}

TEST(PackFinding, EveryKindIsASentence) {
    for (int kind = 0; kind < finding_kind_count; ++kind) {
        const auto sentence = sentence_of(
            {static_cast<FindingKind>(kind), "a\nb.svg", 3, "\x1b[2J\xff", 2.0}, Language());
        EXPECT_TRUE(sentence.starts_with("a b.svg, line 3: ")) << sentence;
        EXPECT_GT(sentence.size(), 40U) << sentence;
        for (const char c : sentence) EXPECT_GE(static_cast<unsigned char>(c), 0x20) << sentence;
    }
}

}  // namespace
}  // namespace touchline
