// Tests drawings that come as scans: what is felt of them, and of what lies around their sheet.
// TOUCHLINE_EXHAUSTIVE=1 makes five times as many (tests/README.md).
#include "tests/app/drawings/scans.h"

#include "tests/app/drawings/charts.h"
#include "tests/app/drawings/felt.h"
#include "vision/simplify/detail_limits.h"

#include <array>
#include <cstdlib>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace touchline {
namespace {

int seeds_of_scans() {
    return std::getenv("TOUCHLINE_EXHAUSTIVE") != nullptr ? 5 : 1;
}

/// Adds the result of one scan, and prints it if it is below the share.
void add_scan(const Result<testing::Drawing>& scan, double least_share, testing::Counted& seen,
              testing::Counted& felt) {
    ASSERT_TRUE(scan.has_value()) << scan.error().line;
    const auto found = testing::felt_of(*scan, most_detail, testing::usual_tolerance_mm);
    ASSERT_TRUE(found.has_value()) << scan->name << ": " << found.error().line;
    seen += found->seen;
    felt += found->felt;
    if (found->seen.share() < least_share || found->felt.share() < least_share)
        fmt::print("{}: {:.1f} % of what is seen is felt, {:.1f} % of what is felt is seen\n",
                   scan->name, 100.0 * found->seen.share(), 100.0 * found->felt.share());
}

void expect_shares(const testing::Counted& seen, const testing::Counted& felt, double least) {
    fmt::print("{:.2f} % of what is seen is felt, {:.2f} % of what is felt is seen\n",
               100.0 * seen.share(), 100.0 * felt.share());
    EXPECT_GE(seen.share(), least);
    EXPECT_GE(felt.share(), least);
}

TEST(Scans, ChartsAreFeltAsTheyWerePrinted) {
    testing::Counted seen;
    testing::Counted felt;
    for (int kind = 0; kind < testing::chart_kind_count(); ++kind)
        for (int seed = 0; seed < seeds_of_scans(); ++seed)
            add_scan(testing::scanned(testing::chart_drawing(kind, seed), seed), 0.97, seen, felt);
    expect_shares(seen, felt, 0.99);
}

TEST(Scans, WhatLiesAroundASheetIsNotFelt) {
    constexpr std::array<int, 3> without_numbers{4, 5, 6};  // pie, floor plan, street map
    testing::Counted seen;
    testing::Counted felt;
    for (int bed = 0; bed < testing::bed_kind_count(); ++bed)
        for (int seed = 0; seed < seeds_of_scans(); ++seed)
            for (const int step : {0, 1}) {
                const int kind = without_numbers[static_cast<std::size_t>(bed + seed + step) % 3];
                add_scan(testing::scanned_on_bed(testing::chart_drawing(kind, seed), bed, seed),
                         0.97, seen, felt);
            }
    expect_shares(seen, felt, 0.99);
}

}  // namespace
}  // namespace touchline
