#include "app/documents/sticks/names.h"

#include "config/types/utf8.h"
#include "tests/app/documents/sticks/any_names.h"

#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <unicode/uchar.h>
#include <unicode/utf8.h>

namespace touchline {
namespace {

using namespace std::string_literals;

struct Sample {
    std::string name, shown;
};

/// The golden table.
const std::vector<Sample> samples{
    {"boat.jpg", "boat.jpg"},
    {"-rf", "-rf"},
    {"%s%n.png", "%s%n.png"},
    {"a\nb.png", "a\ufffdb.png"},
    {"\x1b[2Jgone.png", "\ufffd[2Jgone.png"},
    {"\u202egnp.exe", "\ufffdgnp.exe"},
    {"\xff\xfe.png", "\\xff\\xfe.png"},
    {"K\u00e4se.png", "K\u00e4se.png"},
    {"Anna's dog_2.jpeg", "Anna's dog_2.jpeg"},
    {"<speak>[[x]]&amp;.svg", "<speak>[[x]]&amp;.svg"},
    {"back\\slash.png", "back\\slash.png"},
    {"...", "..."},
    {"..", ".."},
    {"tab\there.png", "tab\ufffdhere.png"},
    {"\u732b.png", "\u732b.png"},
    {"zero\u200bwidth.png", "zero\ufffdwidth.png"},
    {"a\u00a0b.png", "a b.png"},
    {"", ""},
};

TEST(StickNames, AreAsTheTableSays) {
    for (const Sample& sample : samples) {
        EXPECT_EQ(shown_name(sample.name), sample.shown);
    }
}

TEST(StickNames, LongOnesAreCutWhereItIsSaid) {
    EXPECT_EQ(shown_name(std::string(80, 'w')), std::string(80, 'w'));
    EXPECT_EQ(shown_name(std::string(81, 'w')), std::string(79, 'w') + "\u2026");
    std::string wide;
    for (int i = 0; i < 60; ++i) wide += "\u732b";
    EXPECT_EQ(characters_of(shown_name(wide)).size(), 40U);  // 39 of two columns, and the ellipsis
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

}  // namespace
}  // namespace touchline
