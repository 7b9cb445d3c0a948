// Tests how a long list is parted.
#include "app/visit/list_parts.h"

#include "app/visit/screen_model.h"

#include <string>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// The keys of a list, one letter for each row.
std::vector<ListPart> parts_of_keys(const std::string& keys, const ListPart& part) {
    return parts_of(part, keys.size(),
                    [&keys](std::size_t row) { return keys[row] != keys[row - 1]; });
}

std::vector<ListPart> parts_of_keys(const std::string& keys) {
    return parts_of_keys(keys, {0, keys.size()});
}

using Parts = std::vector<ListPart>;

TEST(ListParts, OfAShortListAreItsRows) {
    EXPECT_TRUE(parts_of_keys("").empty());
    EXPECT_TRUE(parts_of_keys("aabbcc").empty());
    EXPECT_EQ(parts_of_keys("aabbccd"), (Parts{{0, 2}, {2, 4}, {4, 6}, {6, 7}}));
}

TEST(ListParts, JoinKeysWhereThereAreManyAndNoPartIsTooLarge) {
    EXPECT_EQ(parts_of_keys("abcdefghi"), (Parts{{0, 6}, {6, 9}}));
    EXPECT_EQ(parts_of_keys("aaabbbbcdefg"), (Parts{{0, 3}, {3, 9}, {9, 12}}));
}

TEST(ListParts, AreEqualWhereOneKeyHasTooMany) {
    EXPECT_EQ(parts_of_keys("aaaaaaaab"), (Parts{{0, 4}, {4, 9}}));
    EXPECT_EQ(parts_of_keys(std::string(8, 'a')), (Parts{{0, 4}, {4, 8}}));
}

/// The most lists, one in the other, that lead to a row.
int depth_of(const std::string& keys, const ListPart& part, std::size_t most_rows) {
    const Parts parts = parts_of_keys(keys, part);
    if (parts.empty()) {
        EXPECT_LE(part.size(), most_rows);
        return 1;
    }
    EXPECT_GE(parts.size(), 2U);
    EXPECT_LE(parts.size(), most_rows);
    std::size_t next = part.first;
    int deepest = 0;
    for (const ListPart& each : parts) {
        EXPECT_EQ(each.first, next) << "no row is lost";
        EXPECT_LT(each.first, each.end);
        next = each.end;
        deepest = std::max(deepest, depth_of(keys, each, most_rows));
    }
    EXPECT_EQ(next, part.end);
    return 1 + deepest;
}

TEST(ListParts, LeadToEveryRowInThreeLists) {
    constexpr std::size_t shown = items_on_screen - 1;
    for (std::size_t rows = 1; rows <= shown * shown * shown; ++rows) {
        for (const std::size_t a_key : {std::size_t{1}, std::size_t{5}, std::size_t{23}, rows}) {
            std::string keys;
            for (std::size_t row = 0; row < rows; ++row)
                keys += static_cast<char>(' ' + static_cast<int>(row / a_key) % 90);
            ASSERT_LE(depth_of(keys, {0, rows}, shown), 3) << rows << ", " << a_key;
        }
    }
    EXPECT_EQ(depth_of(std::string(10'000, 'a'), {0, 10'000}, 22), 3);
}

}  // namespace
}  // namespace touchline
