#include "app/documents/trace/traced.h"

#include <algorithm>
#include <string_view>

#include <gtest/gtest.h>

namespace touchline {
namespace {

std::span<const std::byte> bytes(std::string_view text) {
    return std::as_bytes(std::span(text));
}

TEST(Joined, ThingsComeOutAsTheyWentIn) {
    const ThingsInBytes things{bytes("one"), bytes(""), bytes("three")};
    const std::vector<std::byte> memory = joined(things);
    const ThingsInBytes again = parted(memory, 3);
    ASSERT_EQ(again.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(std::ranges::equal(again[i], things[i])) << i;
}

TEST(Joined, WhatDoesNotFitIsNothing) {
    const std::vector<std::byte> memory = joined({bytes("one"), bytes("two")});
    for (std::size_t size = 0; size < memory.size(); ++size)
        EXPECT_TRUE(parted(std::span(memory).first(size), 2).empty()) << size;
    std::vector<std::byte> longer = memory;
    longer.push_back({});
    EXPECT_TRUE(parted(longer, 2).empty());
    EXPECT_TRUE(parted(memory, 1).empty());
    std::vector<std::byte> greatest = memory;
    for (std::size_t i = 0; i < 8; ++i) greatest[i] = std::byte{255};
    EXPECT_TRUE(parted(greatest, 2).empty());
}

}  // namespace
}  // namespace touchline
