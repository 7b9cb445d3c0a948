// The stages of simplifying, each on its own, on lines in millimetres.
#include "config/types/map_bytes.h"
#include "tests/exact/orientation.h"
#include "vision/simplify/detail_limits.h"
#include "vision/simplify/selection.h"
#include "vision/simplify/shaping.h"
#include "vision/simplify/simplify.h"
#include "vision/simplify/spacing.h"
#include "vision/simplify/surroundings.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <sstream>
#include <utility>

#include <gtest/gtest.h>

namespace touchline {
namespace {

Chain line(double length_mm, double strength, bool is_closed) {
    Chain chain{{}, is_closed};
    const double turn = is_closed ? 0.5 : 1.0;  // there and back
    for (int i = 0; i <= 20; ++i) {
        chain.points.push_back({{turn * length_mm * i / 20.0, 0.0}, strength});
    }
    return chain;
}

TEST(Ranking, LongStrongClosedAndOuterComeFirst) {
    const auto order = ranked({line(20, 10, false), line(80, 10, false), line(80, 10, true),
                               line(80, 5, false), line(80, 10, true)},
                              {1.0, 1.0, 0.0, 1.0, 1.0}, 8.0);
    ASSERT_EQ(order.size(), 5U);
    EXPECT_TRUE(order[0].line.is_closed);
    EXPECT_EQ(order[0].outer_share, 1.0);
    EXPECT_TRUE(order[1].line.is_closed);
    EXPECT_EQ(order[1].outer_share, 0.0);
    EXPECT_NEAR(length_of(order[2].line), 80.0, 1e-9);
    EXPECT_EQ(order[2].line.points[0].strength, 10.0);
    EXPECT_EQ(order[3].line.points[0].strength, 5.0);
    EXPECT_GT(order[3].salience, order[4].salience);
    EXPECT_LE(order[0].salience, 1.0);
}

TEST(Ranking, ALineWithoutStrengthIsTheLastAndNotNothing) {
    const auto order = ranked({line(30, 0, false), line(10, 1, false)}, {1.0, 1.0}, 8.0);
    EXPECT_EQ(order[1].line.points[0].strength, 0.0);
    EXPECT_GT(order[1].salience, 0.0);  // the weight of an outline
    EXPECT_GT(order[0].salience, order[1].salience);
}

TEST(Ranking, NoLineWeighsLessThanAMapMayHold) {
    for (const double length_mm : {1e-6, 0.18, 10.0}) {
        for (const bool is_closed : {false, true}) {
            const auto order = ranked({line(length_mm, 0, is_closed)}, {0.0}, 8.0);
            EXPECT_GE(order[0].salience, MapLimits::least_weight) << length_mm;
        }
    }
}

TEST(Ranking, TiesKeepTheirOrder) {
    const auto order = ranked({line(30, 10, false), line(30, 10, false)}, {1.0, 0.999}, 8.0);
    EXPECT_EQ(order[0].outer_share, 1.0);
}

}  // namespace
}  // namespace touchline

namespace touchline::testing {
namespace {

constexpr ShapingScale tried_scale{0.25, 1.0, 8.0};
const cv::Size2d size_mm(116.0, 84.0);

Chain line(const std::vector<cv::Point2d>& corners, bool is_closed = false) {
    Chain chain{{}, is_closed};
    for (std::size_t i = 0; i + (is_closed ? 0 : 1) < corners.size(); ++i) {
        const cv::Point2d a = corners[i];
        const cv::Point2d b = corners[(i + 1) % corners.size()];
        const int n = std::max(1, static_cast<int>(distance(a, b) / 0.25));
        for (int k = 0; k < n; ++k) {
            chain.points.push_back({a + (static_cast<double>(k) / n) * (b - a), 10.0, k == 0});
        }
    }
    if (!is_closed) chain.points.push_back({corners.back(), 10.0, true});
    return chain;
}

Chain ring(cv::Point2d centre, double radius_mm) {
    Chain chain{{}, true};
    const int n = static_cast<int>(radius_mm * 25.0);
    for (int i = 0; i < n; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / n;
        chain.points.push_back(
            {centre + radius_mm * cv::Point2d(std::cos(angle), std::sin(angle)), 10.0});
    }
    return chain;
}

bool has_point(const Chain& chain, cv::Point2d at) {
    return std::ranges::any_of(chain.points, [&](const EdgePoint& p) { return p.at == at; });
}

TEST(DetailLimits, CountsAndLengthsGrowWithTheAreaGapsDoNot) {
    const DetailLimits table = limits_for(3, {0.172, 0.129});  // diagonal 215 mm
    EXPECT_EQ(table.strokes, 9);
    EXPECT_NEAR(table.line_mm, 1500.0, 1e-9);
    const DetailLimits small = limits_for(3, {0.086, 0.0645});
    EXPECT_EQ(small.strokes, 4);
    EXPECT_NEAR(small.line_mm, 750.0, 1e-9);
    EXPECT_NEAR(small.least_stroke_mm, 12.5, 1e-9);
    EXPECT_EQ(small.gap_mm, table.gap_mm);
    EXPECT_EQ(small.tolerance_mm, table.tolerance_mm);
    EXPECT_EQ(small.least_feature_mm, table.least_feature_mm);
    EXPECT_EQ(limits_for(1, {0.05, 0.05}).strokes, 2);
}

TEST(Shaping, CornersOfTheShapeStayExactlyAndSidesStraight) {
    const Chain square = shaped(line({{10, 10}, {50, 10}, {50, 40}, {10, 40}}, true), tried_scale);
    for (const cv::Point2d corner :
         {cv::Point2d(10, 10), cv::Point2d(50, 10), cv::Point2d(50, 40), cv::Point2d(10, 40)}) {
        EXPECT_TRUE(has_point(square, corner)) << corner;
    }
    EXPECT_EQ(std::ranges::count_if(square.points, &EdgePoint::is_fixed), 4);
    for (const EdgePoint& p : square.points) {
        const double off = std::min({std::abs(p.at.x - 10), std::abs(p.at.x - 50),
                                     std::abs(p.at.y - 10), std::abs(p.at.y - 40)});
        EXPECT_LT(off, 1e-9);
    }
}

TEST(Shaping, TeethFinerThanAFeatureAreSmoothedAway) {
    std::vector<cv::Point2d> teeth;
    for (int i = 0; i <= 40; ++i) teeth.emplace_back(10.0 + i, i % 2 == 0 ? 20.0 : 21.0);
    const Chain flat = shaped(line(teeth), tried_scale);
    EXPECT_EQ(flat.points.front().at, cv::Point2d(10, 20));
    EXPECT_EQ(flat.points.back().at, cv::Point2d(50, 20));
    for (const EdgePoint& p : flat.points) {
        if (p.at.x > 14.0 && p.at.x < 46.0) {
            EXPECT_NEAR(p.at.y, 20.5, 0.05);
        }
    }
}

TEST(Shaping, ACircleStaysACircle) {
    const Chain round = shaped(ring({50, 40}, 20.0), tried_scale);
    for (const EdgePoint& p : round.points) {
        EXPECT_NEAR(distance(p.at, {50, 40}), 20.0 - 1.0 / 40.0, 0.005);
        EXPECT_FALSE(p.is_fixed);
    }
}

TEST(Breaks, FacingEndsAreJoinedAndAnArcBecomesARing) {
    const auto joined = with_breaks_closed({line({{10, 10}, {30, 10}}), line({{33, 10}, {60, 10}}),
                                            line({{10, 50}, {30, 50}}), line({{36, 50}, {60, 50}})},
                                           4.0);
    EXPECT_EQ(joined.size(), 3U);  // closes a gap of 3 mm, but not one of 6 mm
    Chain arc = ring({50, 40}, 20.0);
    arc.is_closed = false;
    arc.points.resize(arc.points.size() - 10);
    const auto closed = with_breaks_closed({arc}, 4.0);
    ASSERT_EQ(closed.size(), 1U);
    EXPECT_TRUE(closed[0].is_closed);
}

TEST(Breaks, EndsThatOtherLinesShareAndLinesBesideEachOtherStay) {
    const auto shared = with_breaks_closed(
        {line({{10, 10}, {30, 10}}), line({{30, 10}, {30, 40}}), line({{32, 10}, {60, 10}})}, 4.0);
    EXPECT_EQ(shared.size(), 3U);
    const auto beside =
        with_breaks_closed({line({{10, 10}, {30, 10}}), line({{30, 13}, {10, 13}})}, 4.0);
    EXPECT_EQ(beside.size(), 2U);
}

TEST(Loops, AFigureOfEightIsTwoRings) {
    Chain eight{{}, true};
    for (int i = 0; i < 400; ++i) {
        const double t = 2.0 * std::numbers::pi * (i + 0.5) / 400;
        eight.points.push_back({{50 + 30 * std::sin(t), 40 + 20 * std::sin(2 * t)}, 1.0});
    }
    const auto parts = without_self_crossings(eight, 10.0);
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_TRUE(parts[0].is_closed && parts[1].is_closed);
    EXPECT_NEAR(length_of(parts[0]) + length_of(parts[1]), length_of(eight), 1.0);
}

TEST(Loops, ASmallLoopIsDropped) {
    const auto parts = without_self_crossings(
        line({{10, 40}, {50, 40}, {52, 42}, {50, 42}, {52, 38}, {100, 38}}), 10.0);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_EQ(parts[0].points.front().at, cv::Point2d(10, 40));
    EXPECT_EQ(parts[0].points.back().at, cv::Point2d(100, 38));
}

/// Returns a line's points as a map holds them: in whole nanometres.
std::vector<Position> on_grid(const Chain& chain) {
    std::vector<Position> points;
    for (const EdgePoint& p : chain.points) {
        points.push_back({std::round(1e6 * p.at.x), std::round(1e6 * p.at.y)});
    }
    return points;
}

/// Counts how often an open line crosses itself.
int crossings_on_grid(const Chain& chain) {
    const std::vector<Position> points = on_grid(chain);
    int count = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        for (std::size_t k = i + 2; k + 1 < points.size(); ++k) {
            count +=
                exact::cross_inside(points[i], points[i + 1], points[k], points[k + 1]) ? 1 : 0;
        }
    }
    return count;
}

/// Counts how often two open lines cross.
int crossings_on_grid(const Chain& one, const Chain& other) {
    const std::vector<Position> points = on_grid(one);
    const std::vector<Position> others = on_grid(other);
    int count = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        for (std::size_t k = 0; k + 1 < others.size(); ++k) {
            count +=
                exact::cross_inside(points[i], points[i + 1], others[k], others[k + 1]) ? 1 : 0;
        }
    }
    return count;
}

TEST(Loops, ALineThatLeadsBackAlongItselfDoesNotCrossItselfInAMap) {
    std::int64_t crossings = 0;
    for (int turn = 1; turn < 60; ++turn) {
        const cv::Point2d along(std::cos(0.1 * turn), std::sin(0.1 * turn));
        Chain hairpin{{}, false};
        for (double s = -20.0; s < 10.0; s += 0.3) {
            hairpin.points.push_back({cv::Point2d(50, 40) + s * along, 1.0});
        }
        for (double s = 9.97; s > 7.0; s -= 0.21) {  // back on the very same way
            hairpin.points.push_back({cv::Point2d(50, 40) + s * along, 1.0});
        }
        crossings += crossings_on_grid(hairpin);
        EXPECT_EQ(crosses_itself_in_map(hairpin), crossings_on_grid(hairpin) > 0);
        for (const Chain& part : without_crossings_in_map(hairpin)) {
            EXPECT_EQ(crossings_on_grid(part), 0) << turn;
        }
    }
    EXPECT_GT(crossings, 50);  // otherwise the test checked nothing
}

TEST(Spacing, ACrossingIsOpenedAndAMeetingIsAFoot) {
    SpacedLines spaced(size_mm, 5.0, 0.25);
    spaced.add(*spaced.fit({line({{10, 40}, {100, 40}})}));
    std::vector<Candidate> open{{line({{50, 10}, {50, 70}})}};
    int crossings = 0;
    while (!open.empty()) {
        auto fit = spaced.fit(open.back());
        open.pop_back();
        if (!fit) continue;
        std::ranges::move(fit->rest, std::back_inserter(open));
        crossings += fit->crossings_opened;
        spaced.add(std::move(*fit));
    }
    ASSERT_EQ(spaced.lines().size(), 3U);
    EXPECT_EQ(crossings, 2);  // one from either side
    std::vector<double> ends;
    for (std::size_t i : {1U, 2U}) {
        ends.push_back(spaced.lines()[i].points.front().at.y);
        ends.push_back(spaced.lines()[i].points.back().at.y);
    }
    std::ranges::sort(ends);
    EXPECT_NEAR(ends[2] - ends[1], 5.0, 1e-9);

    spaced.add(*spaced.fit({line({{80, 10}, {80, 40.2}})}));
    const std::vector<Chain> lines = spaced.lines();
    EXPECT_EQ(lines[3].points.back().at, cv::Point2d(80, 40));
    EXPECT_TRUE(has_point(lines[0], cv::Point2d(80, 40)));
}

/// A line that leads back along itself; the points of each way lie beside those of the other.
Chain there_and_back(cv::Point2d from, cv::Point2d along) {
    Chain chain{{}, false};
    for (double s_mm = 0.0; s_mm < 9.0; s_mm += 0.23) {
        chain.points.push_back({from + s_mm * along, 1.0});
    }
    for (double s_mm = 9.0; s_mm > 1.0; s_mm -= 0.19) {
        chain.points.push_back({from + s_mm * along, 1.0});
    }
    return chain;
}

TEST(Spacing, AFootOnALineThatLeadsBackAlongItselfCrossesNothingInAMap) {
    int feet = 0;
    int short_of_it = 0;
    for (int turn = 0; turn < 60; ++turn) {
        const cv::Point2d along(std::cos(0.1 * turn), std::sin(0.1 * turn));
        const cv::Point2d across(-along.y, along.x);
        const cv::Point2d from(50, 40);
        SpacedLines spaced(size_mm, 5.0, 0.25);
        spaced.add({there_and_back(from, along), {}, {}, 0, {}});
        const cv::Point2d foot = from + 4.7 * along;
        const std::optional<Fit> fit = spaced.fit({line({foot + 30.0 * across, foot})});
        ASSERT_TRUE(fit);
        EXPECT_LT(distance(fit->line.points.back().at, foot), 2e-3);
        ++(fit->back ? feet : short_of_it);
        spaced.add(*fit);
        const std::vector<Chain> lines = spaced.lines();
        EXPECT_EQ(crossings_on_grid(lines[0], lines[1]), 0) << turn;
    }
    EXPECT_GT(feet, 0);  // otherwise the test checked nothing
    EXPECT_GT(short_of_it, 0);
}

TEST(Spacing, ALineThatEndsWellBeforeAnotherKeepsItsDistance) {
    SpacedLines spaced(size_mm, 8.0, 0.25);
    spaced.add(*spaced.fit({line({{10, 40}, {100, 40}})}));
    const auto fit = spaced.fit({line({{50, 10}, {50, 35}})});  // 5 mm short
    ASSERT_TRUE(fit);
    EXPECT_FALSE(fit->back);
    EXPECT_NEAR(fit->line.points.back().at.y, 32.0, 0.4);
    EXPECT_FALSE(spaced.fit({line({{10, 44}, {100, 44}})}));  // beside the other all the way
}

TEST(Spacing, TwoShapesBesideEachOtherStayTwoDownToWhatAFingerTellsApart) {
    const auto second = [](const Chain& first, const Chain& other) {
        SpacedLines spaced(size_mm, 12.0, 0.25);
        spaced.add(*spaced.fit({first}));
        return spaced.fit({other});
    };
    const Chain left = ring({30, 40}, 20.0);
    const auto apart = second(left, ring({74, 40}, 20.0));
    ASSERT_TRUE(apart);
    EXPECT_TRUE(apart->line.is_closed);  // 4 mm apart
    const auto touching = second(left, ring({73, 40}, 20.0));
    ASSERT_TRUE(touching);
    EXPECT_FALSE(touching->line.is_closed);  // 3 mm apart
    EXPECT_TRUE(touching->front && touching->back);
    EXPECT_FALSE(second(left, ring({30, 40}, 14.0)));  // within the first
    EXPECT_FALSE(second(left, ring({30, 40}, 26.0)));  // around the first
    const auto line_beside = second(left, line({{54, 10}, {54, 70}}));
    ASSERT_TRUE(line_beside);  // not a shape: kept the gap
    EXPECT_LT(length_of(line_beside->line), 60.0);
}

TEST(Silhouettes, TheSidesOfAThingAreOneRingWhateverLineLedIntoIt) {
    const std::vector<Chain> lines{line({{20, 20}, {90, 20}, {90, 70}, {55, 70}}),
                                   line({{55, 70}, {20, 70}, {20, 40}, {55, 40}}),  // into it
                                   line({{20, 40}, {20, 20}}), line({{55, 40}, {55, 70}})};
    const std::vector<Chain> joined = with_silhouettes_joined(lines, Outside(lines, size_mm));
    ASSERT_EQ(joined.size(), 3U);
    const auto ring = std::ranges::find_if(joined, &Chain::is_closed);
    ASSERT_NE(ring, joined.end());
    EXPECT_NEAR(held_area(*ring), 70.0 * 50.0, 1e-6);
    double length_mm = 0.0;
    for (const Chain& line : joined) length_mm += line.is_closed ? 0.0 : length_of(line);
    EXPECT_NEAR(length_mm, 35.0 + 30.0, 1e-6);
}

TEST(Silhouettes, WhereALineStandsOutOrTwoThingsTouchAllStaysAsItIs) {
    // Two bars on an axis, which stays one line.
    const std::vector<Chain> bars{line({{10, 70}, {110, 70}}),
                                  line({{20, 70}, {20, 30}, {40, 30}, {40, 70}}),
                                  line({{60, 70}, {60, 50}, {80, 50}, {80, 70}})};
    std::vector<Chain> with_feet = bars;
    with_feet[0] = line({{10, 70}, {20, 70}, {40, 70}, {60, 70}, {80, 70}, {110, 70}});
    const std::vector<Chain> joined = with_silhouettes_joined(with_feet, Outside(bars, size_mm));
    ASSERT_EQ(joined.size(), 3U);
    for (const Chain& line : joined)
        EXPECT_NEAR(length_of(line), line.points[0].at.x == 60 ? 60 : 100, 1e-6);
    const std::vector<Chain> touching{line({{50, 40}, {20, 20}, {20, 60}, {50, 40}}),
                                      line({{50, 40}, {90, 20}, {90, 60}, {50, 40}})};
    EXPECT_EQ(with_silhouettes_joined(touching, Outside(touching, size_mm)).size(), 2U);
}

TEST(Surroundings, WhatARingHoldsIsInsideAndAFrameIsAFrame) {
    const std::vector<Chain> lines{ring({58, 42}, 35.0), ring({58, 42}, 12.0), ring({10, 10}, 6.0)};
    const std::vector<double> shares = Outside(lines, size_mm).shares_of(lines);
    EXPECT_GT(shares[0], 0.95);
    EXPECT_LT(shares[1], 0.05);
    EXPECT_GT(shares[2], 0.95);
    EXPECT_NEAR(held_area(lines[1]), std::numbers::pi * 144.0, 1.0);
    const cv::Rect2d picture(0, 0, 116, 84);
    EXPECT_TRUE(is_frame(line({{2, 2}, {114, 2}, {114, 82}, {2, 82}}, true), picture));
    EXPECT_FALSE(is_frame(line({{12, 12}, {104, 12}, {104, 72}, {12, 72}}, true), picture));
    EXPECT_FALSE(is_frame(lines[0], picture));
    EXPECT_FALSE(is_rim(line({{2, 2}, {114, 2}, {114, 82}, {2, 82}}, true), picture));
    Chain rim = line({{0.5, 0.5}, {115.5, 0.5}, {115.5, 83.5}, {0.5, 83.5}}, true);
    EXPECT_FALSE(is_rim(rim, picture));
    rim.width_px = 1.0;  // its ink reaches the picture's edges
    EXPECT_TRUE(is_rim(rim, picture));
}

TEST(Parts, PlacesAndWords) {
    TactileMap map;
    const auto add = [&](Position at, bool is_closed) {
        Outline outline;
        outline.points = {at, at + Position{0.004, 0.0}, at + Position{0.004, 0.003}};
        outline.is_closed = is_closed;
        map.outlines.push_back(std::move(outline));
    };
    add({-0.05, 0.03}, true);
    add({-0.045, 0.035}, true);
    add({0.0, 0.0}, false);
    add({0.05, -0.035}, false);
    label_by_place(map, {LineOf::edge, LineOf::edge, LineOf::text, LineOf::edge});
    EXPECT_EQ(map.outlines[0].label, "closed line, upper left");
    EXPECT_EQ(map.outlines[1].label, "closed line 2, upper left");
    EXPECT_EQ(map.outlines[2].label, "line of text, middle");
    EXPECT_EQ(map.outlines[3].label, "line, lower right");
    SimplifyReport report;
    report.parts = 4;
    report.line_mm = 322.0;
    report.left_out = 3;
    for (int detail = 1; detail <= 5; ++detail) {
        const std::string words = words_for(map, report, detail);
        EXPECT_EQ(words.rfind("Four parts, 32 centimetres of line, simple.", 0), 0U) << words;
        int in_sentence = 0;
        std::istringstream in(words);
        for (std::string word; in >> word;) {
            EXPECT_LE(++in_sentence, 15) << words;
            if (word.back() == '.') in_sentence = 0;
        }
    }
    EXPECT_EQ(complexity_of(3, 500.0, {}), Complexity::simple);
    EXPECT_EQ(complexity_of(4, 500.0, {}), Complexity::medium);
    EXPECT_EQ(complexity_of(20, 500.0, {}), Complexity::complex);
}

}  // namespace
}  // namespace touchline::testing
