// A point (radius 0) hits exactly what exact arithmetic says that it meets first, at every level
// and blend, however it is aimed. TOUCHLINE_EXHAUSTIVE=1 asks ten million times (tests/README.md).
#include "haptics/collision/scene.h"
#include "tests/exact/orientation.h"
#include "tests/haptics/collision/level_segments.h"
#include "tests/haptics/collision/trials.h"
#include "tests/lab/bench/workload.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr std::int64_t few_ulp = 4;
// Contacts within four ulp of the whole way count as one moment; each may itself be four ulp off.
constexpr double one_moment = 8 * 0x1p-52;

/// Both numbers must be >= 0.
std::int64_t ulps_between(double a, double b) {
    return std::abs(std::bit_cast<std::int64_t>(a + 0.0) - std::bit_cast<std::int64_t>(b + 0.0));
}

/// Returns the last of the moments that follow one another without a gap from the first meeting on.
double last_of_chain(const trials::FromTo& way, const LevelSegments& reference) {
    std::vector<double> shares;
    for (const auto& [ref, segment] : reference.all()) {
        if (const auto share = exact::first_meeting(way.from, way.to, segment)) {
            shares.push_back(*share);
        }
    }
    std::sort(shares.begin(), shares.end());
    const auto gap = std::adjacent_find(shares.begin(), shares.end(),
                                        [](double a, double b) { return b - a > one_moment; });
    return gap == shares.end() ? shares.back() : *gap;
}

struct Tally {
    std::size_t asked = 0;
    std::size_t hits = 0;
    std::size_t wrong = 0;
    std::size_t tied = 0;     // a lower segment, met one moment later
    std::size_t chained = 0;  // of those: met more than one moment later
    std::int64_t worst_ulp = 0;
};

/// Says what is wrong with an answer; empty if nothing is.
std::string fault(const Hit& found, const trials::FromTo& way, const LevelSegments& reference,
                  Tally& tally) {
    const auto expected = reference.first_meeting(way.from, way.to);
    tally.hits += expected ? 1U : 0U;
    if (found.is_hit != expected.has_value()) return expected ? "missed" : "invented";
    if (!expected) return found.clear == 1.0 ? "" : "not clear";
    const std::int64_t off = ulps_between(found.clear, expected->share);
    tally.worst_ulp = std::max(tally.worst_ulp, off);
    if (off > few_ulp) return fmt::format("share off by {} ulp", off);
    if (found.segment > expected->lowest) return "not the lowest segment";
    const auto own = exact::first_meeting(way.from, way.to, reference.segment(found.segment));
    if (!own) return "names a segment that is not met";
    if (*own - expected->share > one_moment) {
        ++tally.chained;
        if (*own > last_of_chain(way, reference)) return "names a segment met later";
    }
    tally.tied += *own != expected->share ? 1U : 0U;
    const std::int64_t touch_off = ulps_between(found.touch.fraction, *own);
    return touch_off > few_ulp ? fmt::format("touch off by {} ulp", touch_off) : "";
}

void ask(const Scene& scene, double level, const LevelSegments& reference,
         const trials::FromTo& way, Tally& tally) {
    const Motion motion{way.from, way.to, 0.0, level, {}};
    const Hit found = scene.tree.first_hit(scene.curves, motion, {});
    const std::string wrong = fault(found, way, reference, tally);
    ++tally.asked;
    if (wrong.empty() || ++tally.wrong > 5) return;
    ADD_FAILURE() << fmt::format(
        "{}: from ({:a}, {:a}) to ({:a}, {:a}) at level {}; found {} at {:.17g}, segment ({}, {}), "
        "opening {} boxes",
        wrong, way.from.x, way.from.y, way.to.x, way.to.y, level, found.is_hit, found.clear,
        found.segment.piece, found.segment.index, found.boxes);
}

/// Asks `count` ways in one scene, over all its levels in turn.
void ask_scene(const Scene& scene, std::size_t count, trials::Random& random, Tally& tally) {
    const std::vector<double> levels = trials::levels_of(scene.curves);
    const std::size_t per_level = (count + levels.size() - 1) / levels.size();
    const std::size_t first = count < levels.size() ? random.below(levels.size()) : 0;
    std::size_t asked = 0;
    for (std::size_t i = 0; asked < count; ++i) {
        const double level = levels[(first + i) % levels.size()];
        const LevelSegments reference(scene.curves, level);
        for (std::size_t k = 0; k < per_level && asked < count; ++k, ++asked) {
            ask(scene, level, reference, trials::way(random, reference), tally);
        }
    }
}

void report(const Tally& tally) {
    fmt::print(
        "  {} ways, {} hits, {} wrong, share off by at most {} ulp; {} named a lower segment "
        "met a moment later, {} of them a moment after that\n",
        tally.asked, tally.hits, tally.wrong, tally.worst_ulp, tally.tied, tally.chained);
    EXPECT_EQ(tally.wrong, 0U);
    EXPECT_GT(tally.hits, tally.asked / 5);
}

TEST(PointHits, EqualTheExactReferenceOnSmallOutlines) {
    constexpr std::size_t ways_each = 500;
    const std::size_t wanted = trials::count(200000, 10000000);
    Tally tally;
    for (std::uint64_t seed = 0; tally.asked < wanted; ++seed) {
        trials::Random random(seed);
        const Scene scene = trials::scene_of(trials::small_map(random), seed);
        if (scene.curves.pieces().empty()) continue;
        ask_scene(scene, ways_each, random, tally);
    }
    report(tally);
}

TEST(PointHits, EqualTheExactReferenceOnFourThousandSegments) {
    const std::size_t wanted = trials::count(1000, 100000);
    Tally tally;
    for (const auto kind : {workload::Kind::radial, workload::Kind::fractal}) {
        trials::Random random(1);
        const TactileMap map = workload::map_of(workload::curve(kind, 4096));
        ask_scene(trials::every_level(map), wanted / 2, random, tally);
    }
    report(tally);
}

TEST(PointHits, EqualTheExactReferenceOnSixtyFiveThousandSegments) {
    const std::size_t wanted = trials::count(60, 1000);
    trials::Random random(2);
    const TactileMap map = workload::map_of(workload::curve(workload::Kind::radial, 65536));
    Tally tally;
    ask_scene(trials::every_level(map), wanted, random, tally);
    report(tally);
}

TEST(PointHits, EqualTheExactReferenceAmongManyTinyOutlines) {
    trials::Random random(3);
    const TactileMap map = trials::tiny_outlines(random, trials::count(10000, 100000));
    Tally tally;
    ask_scene(trials::every_level(map), trials::count(200, 1000), random, tally);
    report(tally);
}

TEST(PointHits, NothingIsHitWhereThereIsNoOutline) {
    const Scene scene = trials::every_level({});
    const Hit hit = scene.tree.first_hit(scene.curves, {{-1, 0}, {1, 0}, 0.0, 0.0, {}}, {});
    EXPECT_FALSE(hit.is_hit);
    EXPECT_EQ(hit.clear, 1.0);
}

}  // namespace
}  // namespace touchline
