// Tests the letters of names, and the order of a list.
#include "app/documents/sticks/first_letters.h"

#include "tests/app/documents/sticks/any_names.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

using Names = std::vector<std::string>;

std::vector<StickEntry> entries_of(const Names& names) {
    std::vector<StickEntry> entries;
    for (const std::string& name : names) entries.push_back({StickFileKind::picture, "", name});
    return entries;
}

Names names_of(const std::vector<StickEntry>& entries) {
    Names names;
    for (const StickEntry& entry : entries) names.push_back(entry.name);
    return names;
}

Names sorted(const Names& names) {
    std::vector<StickEntry> entries = entries_of(names);
    sort_by_name(entries);
    return names_of(entries);
}

TEST(FirstLetters, AreCapitalsWithoutAccentsAndOneForAllDigits) {
    const Names names{"zebra.png", "\u00c4pfel.png",      "a\u0308rger.png", "_cat.png",   "12.png",
                      "***.png",   "\u00f1and\u00fa.png", "\u0153uvre.png",  "\u00dfa.png"};
    EXPECT_EQ(first_letters(names), (Names{"Z", "A", "A", "C", "0", "", "N", "O", "S"}));
}

TEST(FirstLetters, OfOtherScriptsAreLettersToo) {
    const Names names{"\u041c\u0438\u0440.png", "\u0386\u03bb\u03c6\u03b1.png", "\u732b.png"};
    EXPECT_EQ(first_letters(names), (Names{"\u041c", "\u0391", ""}));
}

TEST(FirstLetters, OrderDigitsThenLettersThenTheRestEachNaturally) {
    EXPECT_EQ(sorted({"zebra.png", "_cat.png", "***.png", "b10.png", "B9.png", "12.png", "9.png",
                      "\u00c4pfel.png", "apple.png", "\u732b.png"}),
              (Names{"9.png", "12.png", "\u00c4pfel.png", "apple.png", "B9.png", "b10.png",
                     "_cat.png", "zebra.png", "***.png", "\u732b.png"}));
}

TEST(FirstLetters, PutFilesOfAllFoldersInOneOrder) {
    std::vector<StickEntry> entries{{StickFileKind::picture, "", "boat.png"},
                                    {StickFileKind::picture, "b", "cat.png"},
                                    {StickFileKind::picture, "a", "ant.png"}};
    sort_by_name(entries);
    EXPECT_EQ(names_of(entries), (Names{"ant.png", "boat.png", "cat.png"}));
    EXPECT_EQ(entries[0].folder, "a");
}

/// What begins alike stands together, and no name is lost.
RC_GTEST_PROP(FirstLetters, AreRunsOfASortedList, ()) {
    const auto names = *rc::gen::container<Names>(any_name());
    Names in_order = sorted(names);
    const Names letters = first_letters(in_order);
    for (std::size_t i = 1; i < letters.size(); ++i) {
        const auto earlier = letters.begin() + static_cast<std::ptrdiff_t>(i) - 1;
        if (*earlier == letters[i]) continue;
        RC_ASSERT(std::find(letters.begin(), earlier, letters[i]) == earlier);
    }
    Names before = names;
    std::ranges::sort(before);
    std::ranges::sort(in_order);
    RC_ASSERT(in_order == before);
}

}  // namespace
}  // namespace touchline
