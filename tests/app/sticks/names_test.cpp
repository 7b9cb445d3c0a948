#include "app/sticks/names.h"

#include "config/types/utf8.h"
#include "tests/app/sticks/any_names.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <unicode/uchar.h>
#include <unicode/utf8.h>

namespace touchline {
namespace {

using namespace std::string_literals;

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
    std::string name, shown, logged;
};

/// The golden table: a name in both of its forms.
const std::vector<Sample> samples{
    {"boat.jpg", "boat.jpg", "boat.jpg"},
    {"-rf", "-rf", "-rf"},
    {"%s%n.png", "%s%n.png", "%s%n.png"},
    {"a\nb.png", "a\ufffdb.png", "a\\x0ab.png"},
    {"\x1b[2Jgone.png", "\ufffd[2Jgone.png", "\\x1b[2Jgone.png"},
    {"\u202egnp.exe", "\ufffdgnp.exe", "\\xe2\\x80\\xaegnp.exe"},
    {"\xff\xfe.png", "\\xff\\xfe.png", "\\xff\\xfe.png"},
    {"K\u00e4se.png", "K\u00e4se.png", "K\\xc3\\xa4se.png"},
    {"Anna's dog_2.jpeg", "Anna's dog_2.jpeg", "Anna's dog_2.jpeg"},
    {"<speak>[[x]]&amp;.svg", "<speak>[[x]]&amp;.svg", "<speak>[[x]]&amp;.svg"},
    {"back\\slash.png", "back\\slash.png", "back\\x5cslash.png"},
    {"...", "...", "..."},
    {"..", "..", ".."},
    {"tab\there.png", "tab\ufffdhere.png", "tab\\x09here.png"},
    {"\u732b.png", "\u732b.png", "\\xe7\\x8c\\xab.png"},
    {"zero\u200bwidth.png", "zero\ufffdwidth.png", "zero\\xe2\\x80\\x8bwidth.png"},
    {"a\u00a0b.png", "a b.png", "a\\xc2\\xa0b.png"},
    {"", "", ""},
};

TEST(StickNames, AreAsTheTableSays) {
    for (const Sample& sample : samples) {
        EXPECT_EQ(shown_name(sample.name), sample.shown);
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
}

TEST(StickNames, AccentsArePiledNoHigherThanThree) {
    std::string tower = "a";
    for (int i = 0; i < 50; ++i) tower += "\u0301";
    EXPECT_EQ(shown_name(tower), "a\u0301\u0301\u0301");
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
