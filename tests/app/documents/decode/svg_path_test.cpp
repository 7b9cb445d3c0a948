// Tests every command of SVG's path syntax against points worked out by hand.
#include "app/documents/decode/map_svg.h"
#include "app/documents/decode/svg_shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline::decode {
namespace {

using Points = std::vector<UserPoint>;

std::vector<Subpath> traced(std::string_view d, const Affine& transform = {}) {
    SvgTracer tracer(transform, max_map_points);
    const auto drawn = draw_path(d, tracer);
    EXPECT_TRUE(drawn) << drawn.error().line;
    EXPECT_TRUE(tracer.is_good());
    return tracer.take();
}

Points one(std::string_view d) {
    auto subpaths = traced(d);
    EXPECT_EQ(subpaths.size(), 1U) << d;
    return subpaths.empty() ? Points{} : subpaths[0].points;
}

/// The distance to a polyline over all its segments, independent of the tracer.
double distance_to(const Points& polyline, UserPoint p) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < polyline.size(); ++i) {
        const UserPoint along = polyline[i + 1] - polyline[i];
        const double t = std::clamp(dot(p - polyline[i], along) / dot(along, along), 0.0, 1.0);
        nearest = std::min(nearest, norm(p - polyline[i] - t * along));
    }
    return nearest;
}

TEST(SvgPath, LinesAbsoluteAndRelative) {
    const Points expected{{1, 2}, {4, 6}, {10, 6}, {10, -1}};
    EXPECT_EQ(one("M1 2L4 6H10V-1"), expected);
    EXPECT_EQ(one("m1 2l3 4h6v-7"), expected);
    EXPECT_EQ(one("M1,2 4,6 10,6 10,-1"), expected);  // after a move come lines
    EXPECT_EQ(one("m1,2 3,4 6,0 0,-7"), expected);
    EXPECT_EQ(one(" M 1 , 2 L 4 6 H 7 10 v -3 -4 "),
              (Points{{1, 2}, {4, 6}, {7, 6}, {10, 6}, {10, 3}, {10, -1}}));
}

TEST(SvgPath, NumbersMayTouch) {
    EXPECT_EQ(one("M.5.25-1-.5L1e1+2e-1 1.5e+1,4."),
              (Points{{0.5, 0.25}, {-1, -0.5}, {10, 0.2}, {15, 4}}));
}

TEST(SvgPath, EverySubpathIsItsOwn) {
    const auto subpaths = traced("M0 0L1 0 1 1zM5 5L6 6m1 1l1 0 0 1 -1 0 0 -1L20 20M3 3");
    ASSERT_EQ(subpaths.size(), 3U);
    EXPECT_TRUE(subpaths[0].is_closed);
    EXPECT_EQ(subpaths[0].points, (Points{{0, 0}, {1, 0}, {1, 1}}));
    EXPECT_FALSE(subpaths[1].is_closed);
    EXPECT_EQ(subpaths[1].points, (Points{{5, 5}, {6, 6}}));
    EXPECT_FALSE(subpaths[2].is_closed);
    EXPECT_EQ(subpaths[2].points.size(), 6U);
}

TEST(SvgPath, DrawingGoesOnAfterZFromWhereTheSubpathBegan) {
    const auto subpaths = traced("M2 3h4v4zl-1-1");
    ASSERT_EQ(subpaths.size(), 2U);
    EXPECT_EQ(subpaths[1].points, (Points{{2, 3}, {1, 2}}));
}

TEST(SvgPath, EndingWhereItBeganClosesIt) {
    for (const auto* d : {"M0 0L4 0 4 4 0 0", "M0 0L4 0 4 4 0 0Z", "m0 0h4v4l-4-4z"}) {
        const auto subpaths = traced(d);
        ASSERT_EQ(subpaths.size(), 1U);
        EXPECT_TRUE(subpaths[0].is_closed);
        EXPECT_EQ(subpaths[0].points, (Points{{0, 0}, {4, 0}, {4, 4}}));
    }
    // Ten times 0.1 is not exactly 1, but near enough.
    const auto wandering = traced("M0 0h.1h.1h.1h.1h.1h.1h.1h.1h.1h.1v1h-1v-1");
    EXPECT_TRUE(wandering[0].is_closed);
}

TEST(SvgPath, ThereAndBackIsALine) {
    for (const auto* d : {"M0 0L4 0Z", "M0 0L4 0L0 0", "M0 0L4 0L0 0Z"}) {
        const auto subpaths = traced(d);
        ASSERT_EQ(subpaths.size(), 1U);
        EXPECT_FALSE(subpaths[0].is_closed);
        EXPECT_EQ(subpaths[0].points, (Points{{0, 0}, {4, 0}}));
    }
}

TEST(SvgPath, EqualPointsInARowAreOneAndALonePointIsNothing) {
    EXPECT_EQ(one("M0 0L0 0 1 1 1 1H1"), (Points{{0, 0}, {1, 1}}));
    EXPECT_TRUE(traced("M5 5").empty());
    EXPECT_TRUE(traced("M5 5Z").empty());
    EXPECT_TRUE(traced("M5 5L5 5").empty());
    EXPECT_TRUE(traced("").empty());
}

TEST(SvgPath, CubicsPassWhereDeCasteljauSays) {
    // Halfway: (p0 + 3 p1 + 3 p2 + p3) / 8 = (5, 7.5).
    const Points expected = one("M0 0C0 10 10 10 10 0");
    EXPECT_LT(distance_to(expected, {5, 7.5}), 0.01);
    EXPECT_EQ(expected.front(), (UserPoint{0, 0}));
    EXPECT_EQ(expected.back(), (UserPoint{10, 0}));
    EXPECT_EQ(one("m0 0c0 10 10 10 10 0"), expected);
    EXPECT_EQ(one("M3 4m-3-4C0 10 10 10 10 0"), expected);
}

TEST(SvgPath, SmoothCubicsMirrorTheLastControlPoint) {
    EXPECT_EQ(one("M0 0C0 5 5 5 5 0S10-5 10 0"), one("M0 0C0 5 5 5 5 0C5-5 10-5 10 0"));
    EXPECT_EQ(one("M0 0c0 5 5 5 5 0s5-5 5 0"), one("M0 0C0 5 5 5 5 0C5-5 10-5 10 0"));
    // Without a curve to mirror, the pen itself is the control point.
    EXPECT_EQ(one("M0 0L5 0S10-5 10 0"), one("M0 0L5 0C5 0 10-5 10 0"));
    EXPECT_EQ(one("M0 0Q2 2 5 0S10-5 10 0"), one("M0 0Q2 2 5 0C5 0 10-5 10 0"));
}

TEST(SvgPath, QuadraticsAndTheirSmoothForm) {
    // Halfway: (p0 + 2 c + p1) / 4 = (5, 5).
    EXPECT_LT(distance_to(one("M0 0Q5 10 10 0"), {5, 5}), 0.01);
    EXPECT_EQ(one("M0 0q5 10 10 0"), one("M0 0Q5 10 10 0"));
    EXPECT_EQ(one("M0 0Q5 10 10 0T20 0T30 0"), one("M0 0Q5 10 10 0Q15-10 20 0Q25 10 30 0"));
    EXPECT_EQ(one("M0 0q5 10 10 0t10 0t10 0"), one("M0 0Q5 10 10 0Q15-10 20 0Q25 10 30 0"));
    // Without a curve to mirror, the pen itself is the control point.
    EXPECT_EQ(one("M0 0L5 0T10 3"), one("M0 0L5 0Q5 0 10 3"));
}

TEST(SvgPath, TheFourArcsThroughTwoPoints) {
    // Radius 5 through (0, 0) and (6, 0): centres (3, -4) and (3, 4); y grows downward, so an arc
    // with the sweep flag runs clockwise on the screen: the small one bulges up.
    struct Case {
        const char* d;
        UserPoint centre;
        UserPoint top;  // the middle of the arc
    };

    for (const Case& arc :
         {Case{"M0 0A5 5 0 0 1 6 0", {3, 4}, {3, -1}}, Case{"M0 0A5 5 0 1 1 6 0", {3, -4}, {3, -9}},
          Case{"M0 0A5 5 0 0 0 6 0", {3, -4}, {3, 1}},
          Case{"M0 0A5 5 0 1 0 6 0", {3, 4}, {3, 9}}}) {
        SCOPED_TRACE(arc.d);
        const Points points = one(arc.d);
        EXPECT_EQ(points.front(), (UserPoint{0, 0}));
        EXPECT_EQ(points.back(), (UserPoint{6, 0}));
        for (const UserPoint p : points) EXPECT_NEAR(norm(p - arc.centre), 5.0, 1e-6);
        EXPECT_LT(distance_to(points, arc.top), flattening_tolerance_mm + 1e-6);
    }
}

TEST(SvgPath, ArcsRelativeCompactTurnedTooSmallAndFlat) {
    EXPECT_EQ(one("M1 1a5 5 0 0 1 6 0"), one("M1 1A5 5 0 0 1 7 1"));
    EXPECT_EQ(one("M1 1a5 5 0 016 0"), one("M1 1A5 5 0 0 1 7 1"));  // flags touch
    EXPECT_EQ(one("M1 1a-5 5 0 0 1 6 0"), one("M1 1A5 5 0 0 1 7 1"));
    // Half an ellipse turned by 90 degrees: its radii are 6 vertically and 2 horizontally.
    EXPECT_LT(distance_to(one("M0 0A6 2 90 0 1 4 0"), {2, -6}), flattening_tolerance_mm + 1e-6);
    // A radius that is too short grows to half the distance.
    EXPECT_EQ(one("M0 0A1 1 0 0 1 10 0"), one("M0 0A5 5 0 0 1 10 0"));
    EXPECT_EQ(one("M0 0A0 5 0 0 1 10 0"), (Points{{0, 0}, {10, 0}}));
    EXPECT_EQ(one("M0 0L1 1A5 5 0 0 1 1 1L2 5"), (Points{{0, 0}, {1, 1}, {2, 5}}));
}

TEST(SvgPath, ATransformActsOnPointsControlsAndTolerance) {
    const Affine doubled{2, 0, 0, 2, 1, 1};
    EXPECT_EQ(traced("M0 0C0 10 10 10 10 0", doubled)[0].points, one("M1 1C1 21 21 21 21 1"));
    EXPECT_EQ(traced("M0 0A5 5 0 0 1 6 0", doubled)[0].points, one("M1 1A10 10 0 0 1 13 1"));
}

RC_GTEST_PROP(SvgPath, FlattenedCubicsStayWithinTheTolerance, ()) {
    const auto coordinate = [] { return *rc::gen::inRange(-60000, 60000) / 1000.0; };
    Points control(4);
    for (UserPoint& p : control) p = {coordinate(), coordinate()};
    RC_PRE(control[0] != control[3]);
    SvgTracer tracer({}, max_map_points);
    tracer.move_to(control[0]);
    tracer.cubic_to(control[1], control[2], control[3]);
    const auto subpaths = tracer.take();
    for (int i = 0; i <= 100; ++i) {
        Points b = control;  // de Casteljau
        for (std::size_t n = 3; n > 0; --n) {
            for (std::size_t k = 0; k < n; ++k) b[k] = b[k] + (i / 100.0) * (b[k + 1] - b[k]);
        }
        RC_ASSERT(distance_to(subpaths.at(0).points, b[0]) <= flattening_tolerance_mm + 2e-6);
    }
}

RC_GTEST_PROP(SvgPath, ArcsStayOnTheirEllipseAndReachTheirEnd, ()) {
    const auto number = [](int low, int high) { return *rc::gen::inRange(low, high) / 1000.0; };
    const UserPoint radii{number(500, 50000), number(500, 50000)};
    const UserPoint to{number(-60000, 60000), number(-60000, 60000)};
    RC_PRE(norm(to) > 0.001);
    const double angle_deg = number(-180000, 180000);
    SvgTracer tracer({}, max_map_points);
    tracer.move_to({0, 0});
    tracer.arc_to(radii.x, radii.y, angle_deg, *rc::gen::arbitrary<bool>(),
                  *rc::gen::arbitrary<bool>(), to);
    const auto points = tracer.take().at(0).points;
    RC_ASSERT(points.back() == to);
    // In the ellipse's own axes, scaled to a circle, three points give the centre; all others are
    // checked against it.
    const double turn = angle_deg * 3.14159265358979323846 / 180.0;
    const auto on_circle = [&](UserPoint p) {
        return UserPoint{(p.x * std::cos(turn) + p.y * std::sin(turn)) / radii.x,
                         (p.y * std::cos(turn) - p.x * std::sin(turn)) / radii.y};
    };
    RC_PRE(points.size() >= 9U);
    const UserPoint a = on_circle(points.front());
    const UserPoint b = on_circle(points[points.size() / 2]) - a;
    const UserPoint c = on_circle(points.back()) - a;
    const double area = 2.0 * cross(b, c);
    RC_PRE(std::abs(area) > 1e-2);
    const UserPoint centre{a.x + (c.y * dot(b, b) - b.y * dot(c, c)) / area,
                           a.y + (b.x * dot(c, c) - c.x * dot(b, b)) / area};
    const double radius = norm(a - centre);
    for (const UserPoint p : points) {
        RC_ASSERT(std::abs(norm(on_circle(p) - centre) - radius) < 1e-3 * radius);
    }
}

TEST(SvgPath, WhatIsNoPathIsRefused) {
    for (const auto* d : {"L1 1", "1 1", "M1", "M1 1 2", "M1 1X", "M1 1C1 1 2 2", "Z", "M1 1Z2 2",
                          "M1 1A5 5 0 2 1 6 0", "M1 1A5 5 0 1", "M1 1e999", "Mnan 1", "Minf 0",
                          "M1 1L,,2 2", "M+-1 1", "M1 1L", "M.", "M1 1 2 2e", "M\xc3\xbc"}) {
        SvgTracer tracer({}, max_map_points);
        EXPECT_FALSE(draw_path(d, tracer)) << d;
    }
}

TEST(SvgPath, PointsAreCountedBeforeTheyAreMade) {
    for (const auto* d : {"M0 0C1e300 0 0 1e300 1 1", "M0 0A1e9 1e9 0 1 1 1 1", "M1e308 0l1e308 0",
                          "M0 0A1e300 1e300 0 1 1 1 1", "M0 0A1e-300 1e300 33 1 1 1e-300 1"}) {
        SvgTracer tracer({}, max_map_points);
        ASSERT_TRUE(draw_path(d, tracer)) << d;
        const bool is_good = tracer.is_good();
        const auto subpaths = tracer.take();
        std::size_t count = 0;
        for (const auto& subpath : subpaths) count += subpath.points.size();
        EXPECT_LT(count, std::size_t{1'000'000}) << d;
        EXPECT_TRUE(!is_good || count > 0) << d;
    }
    SvgTracer few({}, 3);
    ASSERT_TRUE(draw_path("M0 0L1 1 2 2 3 3", few));
    EXPECT_FALSE(few.is_good());
}

TEST(SvgTransform, EveryKindAndTheirProduct) {
    EXPECT_EQ(parse_svg_transform(""), Affine{});
    EXPECT_EQ(parse_svg_transform("matrix(1 2 3 4 5 6)"), (Affine{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(parse_svg_transform(" translate(3) "), (Affine{1, 0, 0, 1, 3, 0}));
    EXPECT_EQ(parse_svg_transform("translate(3,4)"), (Affine{1, 0, 0, 1, 3, 4}));
    EXPECT_EQ(parse_svg_transform("scale(2)"), (Affine{2, 0, 0, 2, 0, 0}));
    EXPECT_EQ(parse_svg_transform("scale(2 -3)"), (Affine{2, 0, 0, -3, 0, 0}));
    // The right one acts first.
    EXPECT_EQ(parse_svg_transform("translate(1 2), scale(2)"), (Affine{2, 0, 0, 2, 1, 2}));
    const UserPoint turned = (*parse_svg_transform("rotate(90 10 10)"))({11, 10});
    EXPECT_NEAR(turned.x, 10.0, 1e-12);
    EXPECT_NEAR(turned.y, 11.0, 1e-12);
    EXPECT_NEAR((*parse_svg_transform("skewX(45)"))({0, 2}).x, 2.0, 1e-12);
    EXPECT_NEAR((*parse_svg_transform("skewY(45)"))({2, 0}).y, 2.0, 1e-12);
    for (const auto* text : {"scale()", "scale(1 2 3)", "matrix(1 2 3)", "turn(3)", "scale(2",
                             "scale 2", "rotate(1 2)", "translate(nan)", "(1)", "scale(2))"}) {
        EXPECT_FALSE(parse_svg_transform(text)) << text;
    }
}

TEST(SvgTransform, StretchIsTheGreatestGrowth) {
    EXPECT_DOUBLE_EQ((Affine{3, 0, 0, 2, 9, 9}).stretch(), 3.0);
    EXPECT_DOUBLE_EQ((Affine{0, 2, -2, 0, 0, 0}).stretch(), 2.0);
    EXPECT_DOUBLE_EQ((Affine{1, 1, 1, 1, 0, 0}).stretch(), 2.0);
}

}  // namespace
}  // namespace touchline::decode
