#include "haptics/curve/curve_set.h"

#include "tests/haptics/scenes.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

using scenes::circle;
using scenes::map_of;
using scenes::outline;
using scenes::square;

CurveSet built(const TactileMap& map, const CurveOptions& options = {}) {
    return CurveSet::build(map, options).value();
}

TEST(Pins, AreTheCornersOfASquareAndNothingOfACircle) {
    const auto pins = find_pins({square(0.04, 40), circle(0.02, 200)}, PinRule{});
    EXPECT_EQ(pins[0], (std::vector<std::size_t>{0, 40, 80, 120}));
    EXPECT_TRUE(pins[1].empty());
}

TEST(Pins, AreTheEndsOfAnOpenOutlineAndTheJunctionItLeadsTo) {
    Outline round = circle(0.02, 100);
    const Outline spoke = outline({{0.0, 0.0}, {0.01, 0.0}, round.points[0]}, false);
    const auto pins = find_pins({round, spoke}, PinRule{});
    EXPECT_EQ(pins[0], (std::vector<std::size_t>{0}));
    EXPECT_EQ(pins[1], (std::vector<std::size_t>{0, 2}));
}

TEST(Pins, KeepTheirDistanceAndTheStrongestWins) {
    // Two right angles 3 mm apart and, between them, a sharper one.
    const Outline zigzag =
        outline({{0, 0}, {0.02, 0}, {0.0203, 0.0015}, {0.0206, 0}, {0.05, 0}}, false);
    const auto pins = find_pins({zigzag}, PinRule{});
    EXPECT_EQ(pins[0].size(), 3U);
}

/// The point of a closed outline at an arc length, and the arc length of every vertex: the slow
/// way.
struct Arcs {
    std::vector<Position> points;
    std::vector<double> s{0.0};

    explicit Arcs(const Outline& outline) : points(outline.points) {
        points.push_back(points.front());
        for (std::size_t i = 1; i < points.size(); ++i) {
            s.push_back(s.back() + norm(points[i] - points[i - 1]));
        }
    }

    [[nodiscard]] Position at(double arc) const {
        arc = std::fmod(arc + s.back(), s.back());
        std::size_t i = 1;
        while (i + 1 < s.size() && s[i] < arc) ++i;
        return points[i - 1] + ((arc - s[i - 1]) / (s[i] - s[i - 1])) * (points[i] - points[i - 1]);
    }

    [[nodiscard]] double turn_rad(std::size_t i, double reach) const {
        const Position in = points[i] - at(s[i] - reach);
        const Position out = at(s[i] + reach) - points[i];
        return std::abs(std::atan2(cross(in, out), dot(in, out)));
    }

    [[nodiscard]] double between(std::size_t i, std::size_t j) const {
        const double arc = std::abs(s[i] - s[j]);
        return std::min(arc, s.back() - arc);
    }
};

RC_GTEST_PROP(Pins, AreSharpAndEverySharpVertexIsNearOneAsSharp, ()) {
    const auto seed = *rc::gen::arbitrary<unsigned>();
    const auto parts = *rc::gen::element(1, 2, 7, 40);
    const PinRule rule;
    for (const Outline& drawn : scenes::random_map(seed, 2).outlines) {
        if (!drawn.is_closed) continue;
        Outline dense = outline({}, true);
        for (std::size_t i = 0; i < drawn.points.size(); ++i) {
            const Position a = drawn.points[i];
            const Position b = drawn.points[(i + 1) % drawn.points.size()];
            for (int k = 0; k < parts; ++k) {
                dense.points.push_back(a + (static_cast<double>(k) / parts) * (b - a));
            }
        }
        const Arcs arcs(dense);
        const double reach = std::min(rule.reach_m, arcs.s.back() / 16.0);
        const auto pins = find_pins({dense}, rule)[0];
        std::vector<double> turns_rad;  // of the pins
        for (const std::size_t pin : pins) turns_rad.push_back(arcs.turn_rad(pin, reach));
        for (const double turn_rad : turns_rad) RC_ASSERT(turn_rad > rule.turn_rad - 1e-9);
        for (std::size_t i = 0; i < dense.points.size(); ++i) {
            const double turn_rad = arcs.turn_rad(i, reach);
            if (turn_rad <= rule.turn_rad + 1e-9) continue;
            bool has_near = false;
            for (std::size_t k = 0; k < pins.size(); ++k) {
                has_near |= arcs.between(i, pins[k]) <= rule.apart_m + 1e-12 &&
                            turns_rad[k] >= turn_rad - 1e-9;
            }
            RC_ASSERT(has_near);
        }
    }
}

RC_GTEST_PROP(Pins, AWantedOneIsTheNearestVertexTheFirstOfEquals, (unsigned seed)) {
    std::vector<Outline> outlines = scenes::random_map(seed, 2).outlines;
    outlines.push_back(scenes::rough_ring(seed, 1e-3).outlines[0]);
    for (Outline& outline : outlines) outline.points.push_back(outline.points.front());
    const auto offset = [] { return 1e-3 * *rc::gen::inRange(-50, 50); };
    std::vector<PinPlace> wanted;
    std::vector<std::vector<std::size_t>> pins(outlines.size());
    auto expected = pins;
    for (int i = 0; i < 20; ++i) {
        const auto outline = *rc::gen::inRange<std::size_t>(0, outlines.size());
        const auto& points = outlines[outline].points;
        const Position place = i % 2 == 0
                                   ? Position{offset(), offset()}
                                   : points[*rc::gen::inRange<std::size_t>(0, points.size())];
        wanted.push_back({static_cast<int>(outline), place});
        const auto nearest = std::ranges::min_element(
            points, {}, [&](Position p) { return dot(p - place, p - place); });
        expected[outline].push_back(static_cast<std::size_t>(nearest - points.begin()));
    }
    for (auto& own : expected) {
        std::ranges::sort(own);
        own.erase(std::unique(own.begin(), own.end()), own.end());
    }
    add_pins(outlines, wanted, pins);
    RC_ASSERT(pins == expected);
}

TEST(CurveSet, KeepsEveryVertexAndSplitsLongEdgesIntoCollinearParts) {
    const Outline line =
        outline({{0, 0}, {0.001, 0}, {0.002, 0.0005}, {0.012, 0.0005}, {0.013, 0}}, false);
    const CurveSet curves = built(map_of({line}));
    std::vector<Position> all;
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        const auto points = curves.points(piece, 0);
        all.insert(all.end(), points.begin(), points.end());
    }
    for (const Position p : line.points) EXPECT_NE(std::find(all.begin(), all.end(), p), all.end());
    for (const Position p : all) {
        double nearest = 1.0;
        for (std::size_t i = 1; i < line.points.size(); ++i) {
            nearest =
                std::min(nearest, scenes::distance_m(p, {line.points[i - 1], line.points[i]}));
        }
        EXPECT_LE(nearest, 1e-17);
    }
    EXPECT_GT(all.size(), 10U);
}

TEST(CurveSet, PinsCoincideAtEveryLevelSoThatPiecesNeverComeApart) {
    const CurveSet curves = built(map_of({square(0.04, 64)}));
    ASSERT_EQ(curves.pieces().size(), 4U);
    EXPECT_GE(curves.coarsest(), 3);
    for (int piece = 0; piece < 4; ++piece) {
        const int next = curves.pieces()[static_cast<std::size_t>(piece)].next;
        for (int level = 0; level <= curves.coarsest(); ++level) {
            EXPECT_EQ(curves.points(piece, level).back(), curves.points(piece, 0).back());
            EXPECT_EQ(curves.points(piece, level).back(), curves.points(next, level).front());
        }
    }
}

TEST(CurveSet, ResampledPiecesHaveFourToSevenTimesAPowerOfTwoSegments) {
    CurveOptions options;
    options.resample = true;
    const CurveSet curves = built(map_of({square(0.04, 200), circle(0.015, 300)}), options);
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        const Piece& of = curves.pieces()[static_cast<std::size_t>(piece)];
        const int coarse = curves.segment_count(piece, of.coarsest);
        EXPECT_EQ(curves.segment_count(piece, 0), coarse << of.coarsest);
        EXPECT_GE(coarse, of.is_closed ? 8 : 4);
        EXPECT_LE(coarse, of.is_closed ? 14 : 7);
    }
    EXPECT_LT(curves.reports()[0].points_kept, 100U);
    for (const Position p : circle(0.015, 300).points) {
        double nearest = 1.0;
        for (int j = 0; j < curves.segment_count(4, 0); ++j) {
            nearest = std::min(nearest, scenes::distance_m(p, curves.rendered_segment(4, 0.0, j)));
        }
        EXPECT_LE(nearest, 5e-5);
    }
}

TEST(CurveSet, ABlendLiesBetweenTheCoarsePolylineWithMidpointsAndTheFine) {
    const CurveSet curves = built(map_of({circle(0.03, 77)}));
    for (int i = 0; i < curves.rendered_count(0, 1.25); ++i) {
        const Position fine = curves.rendered_point(0, 1.0, i);
        const auto coarse = curves.points(0, 2);
        const auto half = static_cast<std::size_t>(i / 2);
        const Position other =
            i % 2 == 0 ? coarse[half] : 0.5 * (coarse[half] + coarse[(half + 1) % coarse.size()]);
        EXPECT_LE(norm(curves.rendered_point(0, 1.25, i) - (0.75 * fine + 0.25 * other)), 1e-17);
    }
}

RC_GTEST_PROP(CurveSet, NextAndPreviousUndoEachOtherAndParametersRunOn, ()) {
    const auto seed = *rc::gen::arbitrary<unsigned>();
    const auto level = *rc::gen::element(0.0, 0.5, 1.0, 2.0, 2.7);
    const CurveSet curves = built(scenes::random_map(seed, 3));
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        double before = curves.pieces()[static_cast<std::size_t>(piece)].first_parameter;
        for (int j = 0; j < curves.rendered_count(piece, level); ++j) {
            const SegmentRef next = curves.next({piece, j}, level);
            if (next.piece >= 0) {
                RC_ASSERT(curves.previous(next, level) == (SegmentRef{piece, j}));
                RC_ASSERT(curves.rendered_segment(next.piece, level, next.index).a ==
                          curves.rendered_segment(piece, level, j).b);
            }
            RC_ASSERT(curves.outline_parameter(piece, level, j, 0.0) == before);
            before = curves.outline_parameter(piece, level, j, 1.0);
        }
    }
}

TEST(CurveSet, DegenerateOutlinesAreTakenOrLeftOutWithoutHarm) {
    const CurveSet curves =
        built(map_of({outline({{0, 0}, {0, 0}, {0, 0}}, true), outline({{0, 0}, {0.01, 0}}, true),
                      outline({{0, 0}, {0, 0}, {0.01, 0.01}, {0.01, 0.01}}, false)}));
    ASSERT_EQ(curves.pieces().size(), 2U);
    EXPECT_EQ(curves.pieces()[0].outline, 1);
    EXPECT_FALSE(curves.pieces()[0].is_closed);
    EXPECT_EQ(curves.segment_count(1, 0), 1);
    EXPECT_TRUE(built(TactileMap{}).pieces().empty());
}

TEST(CurveSet, PointsThatAreNoNumbersOrFarAwayAreOneClearLine) {
    for (const double bad : {std::nan(""), 1.5, static_cast<double>(INFINITY)}) {
        const auto curves = CurveSet::build(map_of({outline({{0, 0}, {bad, 0}}, false)}), {});
        ASSERT_FALSE(curves);
        EXPECT_NE(curves.error().line.find("outline 0"), std::string::npos);
    }
}

TEST(CurveSet, ASpacingThatWouldFillTheMemoryIsOneClearLine) {
    for (const bool resample : {false, true}) {
        for (const double spacing_m : {1e-9, 1e-300}) {
            CurveOptions options;
            options.resample = resample;
            options.spacing_m = spacing_m;
            const auto curves = CurveSet::build(map_of({scenes::circle(0.03, 64)}), options);
            ASSERT_FALSE(curves);
            EXPECT_NE(curves.error().line.find("wider spacing"), std::string::npos);
        }
    }
}

TEST(CurveSet, CompressionSaysHowFarItMovedTheCurve) {
    CurveOptions options;
    options.keep_details = 0.1;
    const TactileMap map = scenes::random_map(3, 1);
    const CurveSet whole = built(map);
    const CurveSet small = built(map, options);
    double worst = 0.0;
    for (int piece = 0; piece < static_cast<int>(whole.pieces().size()); ++piece) {
        for (int i = 0; i < whole.rendered_count(piece, 0.0); ++i) {
            worst = std::max(worst, norm(whole.rendered_point(piece, 0.0, i) -
                                         small.rendered_point(piece, 0.0, i)));
        }
    }
    EXPECT_GT(worst, 0.0);
    EXPECT_DOUBLE_EQ(small.reports()[0].shrunk_max_m, worst);
    EXPECT_LE(small.reports()[0].shrunk_rms_m, worst);
}

TEST(LevelError, OfACirclesCoarsePolygonIsItsSagitta) {
    const CurveSet curves = built(map_of({circle(0.03, 512)}));
    const LevelError error = level_error(curves, 0, 4);
    const double sagitta = 0.03 * (1.0 - std::cos(3.14159265358979 / 32.0));
    EXPECT_EQ(error.points, 32U);
    EXPECT_NEAR(error.hausdorff_m, sagitta, 0.02 * sagitta);
    EXPECT_LT(error.rms_m, error.hausdorff_m);
    EXPECT_LE(level_error(curves, 0, 0).hausdorff_m, 1e-17);
}

}  // namespace
}  // namespace touchline
