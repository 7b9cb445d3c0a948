// Tests how a long list is split by letters.
#include "app/documents/sticks/first_letters.h"

#include "tests/app/documents/sticks/any_names.h"

#include <algorithm>
#include <numeric>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

std::vector<std::size_t> all_rows(std::size_t count) {
    std::vector<std::size_t> rows(count);
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    return rows;
}

std::vector<LetterGroup> groups_of(const std::vector<std::string>& names,
                                   const std::string& language = "en") {
    return letter_groups(names, all_rows(names.size()), language);
}

/// Returns each group as "A 2": how its names begin, and their number.
std::vector<std::string> told(const std::vector<LetterGroup>& groups) {
    std::vector<std::string> all;
    for (const LetterGroup& group : groups) {
        const std::string name = group.kind == LetterKind::digits  ? "digits"
                                 : group.kind == LetterKind::other ? "other"
                                                                   : group.beginning;
        all.push_back(name + ' ' + std::to_string(group.rows.size()));
    }
    return all;
}

using Told = std::vector<std::string>;

TEST(FirstLetters, PartAListInTheOrderOfTheAlphabet) {
    EXPECT_EQ(told(groups_of({"zebra.png", "Apple.png", "apple 2.png", "boat.png", "\u00c4pfel.png",
                              "a\u0308rger.png", "_cat.png", "12.png", "7 swans.png", "***.png"})),
              (Told{"digits 2", "A 4", "B 1", "C 1", "Z 1", "other 1"}));
}

TEST(FirstLetters, AreThoseOfTheLanguage) {
    const std::vector<std::string> names{"nube.png",       "\u00f1and\u00fa.png", "oso.png",
                                         "\u0153uvre.png", "\u00dfa.png",         "sol.png"};
    EXPECT_EQ(told(groups_of(names, "es")), (Told{"N 1", "\u00d1 1", "O 2", "S 2"}));
    EXPECT_EQ(told(groups_of(names, "fr")), (Told{"N 2", "O 2", "S 2"}));
    EXPECT_EQ(told(groups_of(names, "de")), (Told{"N 2", "O 2", "S 2"}));
}

TEST(FirstLetters, OfOtherScriptsAreLettersToo) {
    EXPECT_EQ(told(groups_of({"\u041c\u0438\u0440.png", "\u043c\u043e\u0440\u0435.png",
                              "\u0386\u03bb\u03c6\u03b1.png", "\u03b1\u03b2.png", "\u732b.png",
                              "\u72ac.png", "a.png"})),
              (Told{"A 1", "\u0391 2", "\u041c 2", "other 2"}));
}

/// A camera's names begin alike: they are split at the first place where they differ.
TEST(FirstLetters, LeadThroughThousandsOfACamera) {
    std::vector<std::string> names;
    for (int i = 0; i < 3000; ++i) {
        std::string number = std::to_string(i);
        number.insert(0, 4 - number.size(), '0');
        names.push_back("IMG_" + number + ".JPG");
    }
    auto groups = groups_of(names);
    EXPECT_EQ(told(groups), (Told{"IMG0 1000", "IMG1 1000", "IMG2 1000"}));
    groups = letter_groups(names, groups[1].rows, "en");
    ASSERT_EQ(groups.size(), 10U);
    EXPECT_EQ(groups[4].beginning, "IMG14");
    groups = letter_groups(names, groups[4].rows, "en");
    EXPECT_EQ(groups[9].beginning, "IMG149");
    EXPECT_EQ(groups[9].rows.size(), 10U);
    EXPECT_EQ(names[groups[9].rows[0]], "IMG_1490.JPG");
}

TEST(FirstLetters, DigitsAreOneGroupOnlyBesideLetters) {
    EXPECT_EQ(told(groups_of({"2019.png", "2023.png", "a.png"})), (Told{"digits 2", "A 1"}));
    EXPECT_EQ(told(groups_of({"2019.png", "2023.png"})), (Told{"201 1", "202 1"}));
    EXPECT_EQ(told(groups_of({"1.png", "2.png"})), (Told{"1 1", "2 1"}));
}

TEST(FirstLetters, NamesThatEndOrAreTheSameAreAGroup) {
    EXPECT_EQ(told(groups_of({"ab.png", "abc.png"})), (Told{"AB 1", "ABC 1"}));
    EXPECT_EQ(told(groups_of({"ab.png", "AB.jpg"})), (Told{"AB 2"}));
    EXPECT_EQ(told(groups_of({"!.png"})), (Told{"other 1"}));
    EXPECT_TRUE(groups_of({}).empty());
}

/// Every name is in exactly one group, in order, and splitting goes on until nothing tells the
/// names apart.
RC_GTEST_PROP(FirstLetters, LoseNoNameAndComeToAnEnd, ()) {
    const auto names = *rc::gen::container<std::vector<std::string>>(any_name());
    RC_PRE(!names.empty());
    std::vector<std::size_t> rows = all_rows(names.size());
    for (int step = 0; step < 100; ++step) {
        const auto groups = letter_groups(names, rows, "de");
        std::multiset<std::size_t> seen;
        for (const LetterGroup& group : groups) {
            RC_ASSERT(!group.rows.empty());
            RC_ASSERT(std::ranges::is_sorted(group.rows));
            seen.insert(group.rows.begin(), group.rows.end());
        }
        RC_ASSERT(std::ranges::equal(seen, rows));
        if (groups.size() < 2) return;
        rows = groups[*rc::gen::inRange<std::size_t>(0, groups.size())].rows;
    }
    RC_FAIL("it goes on for ever");
}

}  // namespace
}  // namespace touchline
