#include "app/sticks/names.h"

#include "config/types/utf8.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <unicode/uchar.h>
#include <unicode/utf8.h>

namespace touchline {
namespace {

using namespace std::string_literals;

/// What people and attackers put into names.
rc::Gen<std::string> any_name() {
    const auto piece = rc::gen::oneOf(
        rc::gen::map(rc::gen::arbitrary<char>(), [](char c) { return std::string(1, c); }),
        rc::gen::elementOf(std::vector<std::string>{"a",          "Z",
                                                    "7",          " ",
                                                    ".",          "'",
                                                    "\\",         "<",
                                                    "[[",         "%s",
                                                    "\n",         "\x1b[2J",
                                                    "\u00e4",     "e\u0301",
                                                    "\u0301",     "\u200b",
                                                    "\u202e",     "\u2066",
                                                    "\ufeff",     "\u2028",
                                                    "\u3164",     "\u732b",
                                                    "\U0001f41f", "\U000e0041",
                                                    "\xc0\xaf",   "\xed\xa0\x80",
                                                    "\xff",       "\u0085"}));
    return rc::gen::map(rc::gen::container<std::vector<std::string>>(piece), [](const auto& all) {
        std::string name;
        for (const std::string& one : all) name += one;
        return name;
    });
}

std::u32string characters_of(const std::string& text) {
    std::u32string all;
    for (std::size_t i = 0; i < text.size();) {
        UChar32 c = 0;
        U8_NEXT_UNSAFE(text.data(), i, c);
        all.push_back(static_cast<char32_t>(c));
    }
    return all;
}

bool has_mask(char32_t c, std::uint32_t mask) {
    return (U_MASK(u_charType(static_cast<UChar32>(c))) & mask) != 0;
}

/// The inverse of logged_name(), by its description.
std::string read_back(const std::string& logged) {
    std::string name;
    for (std::size_t i = 0; i < logged.size(); ++i) {
        if (logged[i] != '\\') {
            name += logged[i];
            continue;
        }
        name += static_cast<char>(std::stoi(logged.substr(i + 2, 2), nullptr, 16));
        i += 3;
    }
    return name;
}

struct Sample {
    std::string name, shown, spoken, logged;
};

/// The golden table: a name in each of its three forms.
const std::vector<Sample> samples{
    {"boat.jpg", "boat.jpg", "boat", "boat.jpg"},
    {"-rf", "-rf", "rf", "-rf"},
    {"%s%n.png", "%s%n.png", "s n", "%s%n.png"},
    {"a\nb.png", "a\ufffdb.png", "a b", "a\\x0ab.png"},
    {"\x1b[2Jgone.png", "\ufffd[2Jgone.png", "2Jgone", "\\x1b[2Jgone.png"},
    {"\u202egnp.exe", "\ufffdgnp.exe", "gnp", "\\xe2\\x80\\xaegnp.exe"},
    {"\xff\xfe.png", "\\xff\\xfe.png", "a file without a name", "\\xff\\xfe.png"},
    {"K\u00e4se.png", "K\u00e4se.png", "K\u00e4se", "K\\xc3\\xa4se.png"},
    {"Anna's dog_2.jpeg", "Anna's dog_2.jpeg", "Anna's dog 2", "Anna's dog_2.jpeg"},
    {"<speak>[[x]]&amp;.svg", "<speak>[[x]]&amp;.svg", "speak x amp", "<speak>[[x]]&amp;.svg"},
    {"back\\slash.png", "back\\slash.png", "back slash", "back\\x5cslash.png"},
    {"...", "...", "a file without a name", "..."},
    {"..", "..", "a file without a name", ".."},
    {"tab\there.png", "tab\ufffdhere.png", "tab here", "tab\\x09here.png"},
    {"\u732b.png", "\u732b.png", "\u732b", "\\xe7\\x8c\\xab.png"},
    {"zero\u200bwidth.png", "zero\ufffdwidth.png", "zero width", "zero\\xe2\\x80\\x8bwidth.png"},
    {"a\u00a0b.png", "a b.png", "a b", "a\\xc2\\xa0b.png"},
    {"", "", "a file without a name", ""},
};

TEST(StickNames, AreAsTheTableSays) {
    for (const Sample& sample : samples) {
        EXPECT_EQ(shown_name(sample.name), sample.shown);
        EXPECT_EQ(spoken_name(sample.name), sample.spoken);
        EXPECT_EQ(logged_name(sample.name), sample.logged);
    }
}

TEST(StickNames, LongOnesAreCutWhereItIsSaid) {
    EXPECT_EQ(shown_name(std::string(80, 'w')), std::string(80, 'w'));
    EXPECT_EQ(shown_name(std::string(81, 'w')), std::string(79, 'w') + "\u2026");
    std::string wide;
    for (int i = 0; i < 60; ++i) wide += "\u732b";
    EXPECT_EQ(characters_of(shown_name(wide)).size(), 40U);  // 39 of two columns, the ellipsis
    EXPECT_EQ(logged_name(std::string(320, 'w')), std::string(320, 'w'));
    EXPECT_EQ(logged_name(std::string(321, 'w')), std::string(320, 'w') + "...");
    EXPECT_EQ(spoken_name(std::string(200, 'w')), std::string(80, 'w'));
    EXPECT_EQ(spoken_name(std::string(70, 'a') + ' ' + std::string(70, 'b')), std::string(70, 'a'));
}

TEST(StickNames, AccentsArePiledNoHigherThanThree) {
    std::string tower = "a";
    for (int i = 0; i < 50; ++i) tower += "\u0301";
    EXPECT_EQ(shown_name(tower), "a\u0301\u0301\u0301");
    EXPECT_EQ(spoken_name(tower), "a\u0301\u0301\u0301");
}

RC_GTEST_PROP(StickNames, ShownOnesAreOneSafeLineOfEightyColumns, ()) {
    const std::string shown = shown_name(*any_name());
    RC_ASSERT(is_utf8(shown));
    std::size_t columns = 0;
    for (const char32_t c : characters_of(shown)) {
        RC_ASSERT(!has_mask(c, U_GC_C_MASK | U_GC_ZL_MASK | U_GC_ZP_MASK));
        RC_ASSERT(!has_mask(c, U_GC_Z_MASK) || c == U' ');
        if (!has_mask(c, U_GC_M_MASK)) ++columns;
    }
    RC_ASSERT(columns <= shown_columns);
}

RC_GTEST_PROP(StickNames, SpokenOnesAreWords, ()) {
    const std::string spoken = spoken_name(*any_name());
    RC_ASSERT(is_utf8(spoken));
    RC_ASSERT(!spoken.empty());
    RC_ASSERT(spoken.front() != ' ');
    RC_ASSERT(spoken.back() != ' ');
    RC_ASSERT(spoken.find("  ") == std::string::npos);
    const auto all = characters_of(spoken);
    RC_ASSERT(all.size() <= spoken_characters);
    for (const char32_t c : all)
        RC_ASSERT(has_mask(c, U_GC_L_MASK | U_GC_M_MASK | U_GC_N_MASK) || c == U' ' || c == U'\'');
}

RC_GTEST_PROP(StickNames, LoggedOnesArePlainAndCanBeReadBack, ()) {
    const std::string name = *any_name();
    const std::string logged = logged_name(name);
    RC_ASSERT(
        std::all_of(logged.begin(), logged.end(), [](char c) { return c >= ' ' && c <= '~'; }));
    RC_ASSERT(logged.size() <= logged_bytes + 3);
    if (4 * name.size() <= logged_bytes) RC_ASSERT(read_back(logged) == name);
}

}  // namespace
}  // namespace touchline
