// The parity of crossings() equals the exact change between inside and outside of closed curves.
#include "haptics/collision/scene.h"
#include "tests/haptics/collision/crossings.h"
#include "tests/haptics/collision/level_segments.h"
#include "tests/haptics/collision/trials.h"

#include <algorithm>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace touchline {
namespace {

/// Whether every piece closes, alone or with those that it shares pins with.
bool is_closed(const CurveSet& curves) {
    const auto pieces = curves.pieces();
    return std::all_of(pieces.begin(), pieces.end(),
                       [](const Piece& piece) { return piece.is_closed || piece.next >= 0; });
}

trials::FromTo aimed(trials::Random& random, const LevelSegments& segments) {
    return random.below(4) == 0 ? trials::way(random, segments)
                                : trials::way_through_vertex(random, segments);
}

TEST(Crossings, ParityIsTheExactChangeBetweenInsideAndOutside) {
    constexpr int ways_each_level = 50;
    const std::size_t wanted = trials::count(50000, 1500000);
    std::size_t asked = 0;
    std::size_t changes = 0;
    std::size_t wrong = 0;
    for (std::uint64_t seed = 0; asked < wanted; ++seed) {
        trials::Random random(seed);
        const Scene scene = trials::scene_of(trials::closed_map(random), seed);
        if (scene.curves.pieces().empty() || !is_closed(scene.curves)) continue;
        for (const double level : trials::levels_of(scene.curves)) {
            const LevelSegments reference(scene.curves, level);
            for (int i = 0; i < ways_each_level; ++i) {
                const auto [from, to] = aimed(random, reference);
                if (reference.holds(from) || reference.holds(to)) continue;
                const bool is_change = reference.is_inside(from) != reference.is_inside(to);
                const int crossings =
                    touchline::crossings(scene.tree, scene.curves, from, to, level);
                ++asked;
                changes += is_change ? 1U : 0U;
                if ((crossings % 2 != 0) == is_change || ++wrong > 5) continue;
                ADD_FAILURE() << fmt::format(
                    "seed {} level {}: {} crossings from ({:a}, {:a}) to ({:a}, {:a})", seed, level,
                    crossings, from.x, from.y, to.x, to.y);
            }
        }
    }
    fmt::print("  {} ways, {} changes, {} wrong\n", asked, changes, wrong);
    EXPECT_EQ(wrong, 0U);
    EXPECT_GT(changes, asked / 10);
}

}  // namespace
}  // namespace touchline
