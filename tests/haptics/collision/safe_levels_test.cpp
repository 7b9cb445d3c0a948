// On the way from level to level no line passes over another that it does not pass at level 0.
#include "haptics/collision/scene.h"
#include "tests/bench/workload.h"
#include "tests/exact/orientation.h"
#include "tests/haptics/collision/trials.h"
#include "tests/haptics/scenes.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace touchline {
namespace {

struct Rendered {
    int piece, span;  // the node that holds it
    int spans;        // of the piece
    Segment segment;
};

std::vector<Rendered> rendered(const CurveSet& curves, double level) {
    std::vector<Rendered> all;
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        const double own = curves.rendered_level(piece, level);
        const bool is_blend = own > std::floor(own);
        const RenderedPiece at = curves.rendered(piece, level);
        const int spans = curves.segment_count(piece, static_cast<int>(std::ceil(own)));
        for (int j = 0; j < at.segment_count(); ++j) {
            all.push_back({piece, is_blend ? j / 2 : j, spans, at.segment(j)});
        }
    }
    return all;
}

bool are_neighbours(const CurveSet& curves, const Rendered& a, const Rendered& b) {
    const auto follows = [&](const Rendered& before, const Rendered& after) {
        const Piece& piece = curves.pieces()[static_cast<std::size_t>(before.piece)];
        const int next = piece.is_closed ? before.piece : piece.next;
        const bool is_over = before.span + 1 == before.spans && after.span == 0;
        return (before.piece == after.piece && before.span + 1 == after.span) ||
               (is_over && after.piece == next);
    };
    const bool is_same = a.piece == b.piece && a.span == b.span;
    return is_same || follows(a, b) || follows(b, a);
}

/// Pairs of segments that meet and are not held by neighbours.
int meetings(const CurveSet& curves, double level) {
    const std::vector<Rendered> all = rendered(curves, level);
    int met = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = i + 1; j < all.size(); ++j) {
            if (are_neighbours(curves, all[i], all[j])) continue;
            const Segment& s = all[i].segment;
            const Segment& t = all[j].segment;
            met += exact::meet(s.a, s.b, t.a, t.b) ? 1 : 0;
        }
    }
    return met;
}

int levels_with_meetings(const CurveSet& curves) {
    int levels = 0;
    for (double level = 0.0; level <= curves.coarsest(); level += 0.0625) {
        levels += meetings(curves, level) > 0 ? 1 : 0;
    }
    return levels;
}

/// Two rings, one `gap_m` within the other, with waves that coarse levels lose; each has its
/// vertices elsewhere.
TactileMap nested_rings(unsigned seed, double gap_m) {
    std::vector<Outline> rings;
    const double waves = 5.0 + seed % 23;
    for (const double inset_m : {0.0, gap_m}) {
        const int edges = inset_m > 0.0 ? 213 : 256;
        std::vector<Position> points;
        for (int i = 0; i < edges; ++i) {
            const double angle = 2.0 * std::numbers::pi * (i + 0.37) / edges;
            const double radius_m = 0.03 - inset_m + 0.003 * std::sin(waves * angle);
            points.push_back(radius_m * Position{std::cos(angle), std::sin(angle)});
        }
        rings.push_back(scenes::outline(std::move(points), true));
    }
    return scenes::map_of(std::move(rings));
}

TEST(SafeLevels, LinesThatDoNotMeetAtLevel0MeetAtNoOther) {
    int apart = 0;
    int unsafe = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        const TactileMap map = nested_rings(seed, 0.0025 - 5e-5 * seed);
        const CurveSet every = trials::every_level(map).curves;
        if (meetings(every, 0.0) > 0) continue;
        ++apart;
        unsafe += levels_with_meetings(every) > 0 ? 1 : 0;
        const Scene scene = build_scene(map, {}, 0.0).value();
        EXPECT_EQ(levels_with_meetings(scene.curves), 0) << seed;
    }
    EXPECT_GT(apart, 10);
    EXPECT_GT(unsafe, 5);  // of those apart, with all levels kept
}

/// Two waves that cross in the middle at 10 degrees, 400 edges of 0.2 mm each.
TactileMap crossing_waves() {
    std::vector<Outline> waves;
    for (const double sign : {1.0, -1.0}) {
        std::vector<Position> points;
        for (int i = -200; i <= 200; ++i) {
            const double x = 2e-4 * i;
            const double y = sign * std::tan(std::numbers::pi / 36.0) * x;
            points.push_back({x, y + 5e-4 * std::sin(600.0 * x)});
        }
        waves.push_back(scenes::outline(std::move(points), false));
    }
    return scenes::map_of(std::move(waves));
}

TEST(SafeLevels, PinsPartACrossingFromTheRest) {
    const TactileMap map = crossing_waves();
    const CurveSet every = trials::every_level(map).curves;
    const CurveSet safe = build_scene(map, {}, 0.0).value().curves;
    ASSERT_GT(safe.pieces().size(), every.pieces().size());
    std::size_t fine = 0;
    std::size_t all = 0;
    for (int piece = 0; piece < static_cast<int>(safe.pieces().size()); ++piece) {
        const int edges = safe.segment_count(piece, 0);
        const int kept = safe.pieces()[static_cast<std::size_t>(piece)].coarsest;
        const double length_m = 2e-4 * edges / safe.segment_count(piece, kept);
        fine += length_m < 1.25e-3 ? static_cast<std::size_t>(edges) : 0;
        all += static_cast<std::size_t>(edges);
    }
    EXPECT_EQ(all, every.finest_count() - 2);
    EXPECT_LE(fine, all / 10);
    for (double level = 0.0; level <= safe.coarsest(); level += 0.0625) {
        EXPECT_GT(meetings(safe, level), 0) << level;  // they go on crossing
    }
}

TEST(SafeLevels, TakeNothingFromLinesThatKeepClearOfThemselves) {
    for (const auto kind : {workload::Kind::radial, workload::Kind::fractal}) {
        const TactileMap map = workload::map_of(workload::curve(kind, 4096));
        const CurveSet every = trials::every_level(map).curves;
        const CurveSet safe = build_scene(map, {}, 0.0).value().curves;
        ASSERT_EQ(safe.pieces().size(), every.pieces().size());
        for (std::size_t piece = 0; piece < safe.pieces().size(); ++piece) {
            EXPECT_EQ(safe.pieces()[piece].coarsest, every.pieces()[piece].coarsest);
        }
    }
}

}  // namespace
}  // namespace touchline
