// The short form of the maps: a few cells of every slice.

#include "tests/lab/stability/maps.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace touchline::stability {
namespace {

std::vector<Cell> some_cells() {
    std::vector<Cell> some;
    for (const Slice& slice : slices()) {
        for (std::size_t i = 5; i < slice.cells.size(); i += 24) some.push_back(slice.cells[i]);
    }
    return some;
}

TEST(StabilityMaps, NothingIsUnstableBelowPassivityAndTheResultIsTheRecordedOne) {
    const std::vector<Cell> cells = some_cells();
    const std::vector<CellResult> results = measure_all(cells);
    std::uint64_t hash = hashed("");
    int claimed = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::string line = csv_line(cells[i], results[i]);
        hash = hashed(line, hash);
        EXPECT_EQ(results[i].unstable_below, 0) << line;
        const double least = std::min(results[i].limits.passive, results[i].limits.quantiser);
        if (least < 1.0) continue;
        ++claimed;
        EXPECT_GE(results[i].stiffness_N_per_m, 0.94 * least) << line;
    }
    EXPECT_GT(claimed, 15);
    EXPECT_EQ(fmt::format("{:016x}", hash), "607c6e5b8ecb7999");
}

TEST(StabilityMaps, FindTheCellsThatFailBelowALimit) {
    Cell cell;
    cell.loop.tip.coulomb_N = 0.0;
    EXPECT_TRUE(comes_to_rest(cell, 0.95 * limits_of(cell).passive));
    EXPECT_FALSE(comes_to_rest(cell, 1.05 * limits_of(cell).passive));
}

TEST(Hash, IsFowlerNollVo) {
    EXPECT_EQ(hashed(""), 0xcbf29ce484222325U);
    EXPECT_EQ(hashed("foobar"), 0x85944171f73967e8U);
    EXPECT_EQ(hashed("bar", hashed("foo")), hashed("foobar"));
}

}  // namespace
}  // namespace touchline::stability
