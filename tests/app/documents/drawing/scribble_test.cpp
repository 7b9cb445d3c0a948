// Tests strokes that nobody can follow, or that would hold up the screen's thread: each is refused
// or taken within the time of a few frames.
#include "app/documents/drawing/drawing.h"
#include "app/documents/drawing/touch_lines.h"
#include "haptics/collision/scene.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using Points = std::vector<Position>;

struct Tried {
    Drawing::Or<Drawing> drawing;
    double least_s = 0.0;  // of three times: the machine may be under load
};

Tried tried(const Drawing& before, const Points& stroke) {
    Tried result{before, 1e9};
    for (int i = 0; i < 3; ++i) {
        const auto from = std::chrono::steady_clock::now();
        result.drawing = before.with_stroke(stroke);
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - from;
        result.least_s = std::min(result.least_s, took.count());
    }
    return result;
}

/// Round and round, `loops` times, while the middle goes from left to right.
Points curls(int loops, double radius_m, double across_m) {
    Points way;
    const int count = 100 * loops;
    for (int i = 0; i <= count; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / 100.0;
        const double middle_m = across_m * (static_cast<double>(i) / count - 0.5);
        way.push_back({middle_m + radius_m * std::cos(turn), radius_m * std::sin(turn)});
    }
    return way;
}

/// To and fro over a square, `pitch_m` apart.
Points hatching(double side_m, double pitch_m, double way_m) {
    Points way{{-0.5 * side_m, -0.5 * side_m}};
    for (int i = 0; i * side_m < way_m; ++i) {
        const double y_m = -0.5 * side_m + i * pitch_m;
        const double x_m = (i % 2 == 0 ? 0.5 : -0.5) * side_m;
        way.push_back({x_m, y_m});
        way.push_back({x_m, y_m + pitch_m});
    }
    return way;
}

/// As fast as a hand can, from edge to edge without lifting.
Points wild_scribble(std::size_t points) {
    Points way;
    for (std::size_t i = 0; i < points; ++i) {
        const double at = static_cast<double>(i);
        way.push_back({0.055 * std::sin(1.7 * at), 0.04 * std::sin(2.3 * at + 0.2)});
    }
    return way;
}

TEST(Scribble, ManyMetresWithoutLiftingAreRefusedAtOnce) {
    const Tried wild = tried(Drawing(7), wild_scribble(most_stroke_points));
    EXPECT_EQ(wild.drawing.error(), DrawingRefusal::too_long);
    EXPECT_LT(wild.least_s, 0.5);
}

TEST(Scribble, ALineThatCrossesItselfManyTimesIsRefusedAndAFewCurlsAreNot) {
    EXPECT_EQ(Drawing(7).with_stroke(curls(70, 0.0033, 0.05)).error(), DrawingRefusal::scribbled);
    const auto few = Drawing(7).with_stroke(curls(8, 0.005, 0.06));
    ASSERT_TRUE(few);
    EXPECT_GT(few->lines()[0]->outlines.size(), 4U);
}

TEST(Scribble, AnInkBlotIsRefused) {
    EXPECT_EQ(Drawing(7).with_stroke(hatching(0.01, 1e-5, 1.4)).error(), DrawingRefusal::scribbled);
    EXPECT_TRUE(Drawing(7).with_stroke(hatching(0.06, 0.003, 1.2)));
}

/// The strokes that take longest of those that are let through, and of those that are not.
TEST(Scribble, NoStrokeHoldsUpTheScreen) {
    double taken_s = 0.0;
    double refused_s = 0.0;
    double built_s = 0.0;
    const auto look = [&](const Points& stroke) {
        const Tried result = tried(Drawing(7), stroke);
        double& most_s = result.drawing ? taken_s : refused_s;
        most_s = std::max(most_s, result.least_s);
        if (!result.drawing) return;
        const TactileMap map = map_of(*result.drawing, "A drawing", [](int) { return "Line"; });
        const auto from = std::chrono::steady_clock::now();
        ASSERT_TRUE(build_scene(map, CurveOptions{}, 0.005));
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - from;
        built_s = std::max(built_s, took.count());
    };
    for (const int loops : {8, 12, 16, 20, 25, 30, 40, 50, 60, 90, 200})
        for (const double across_m : {0.002, 0.01, 0.05, 0.1})
            for (const double way_m : {1.0, 1.45, 1.95})
                look(curls(loops, way_m / (2.0 * std::numbers::pi * loops), across_m));
    for (const double side_m : {0.005, 0.02, 0.06})
        for (const double pitch_m : {1e-5, 1e-4, 3e-4, 6e-4, 1e-3, 0.003})
            look(hatching(side_m, pitch_m, 1.45));
    for (const std::size_t points : {10U, 15U, 20U, 25U, 30U}) look(wild_scribble(points));
    RecordProperty("taken_ms", std::to_string(1e3 * taken_s));
    RecordProperty("refused_ms", std::to_string(1e3 * refused_s));
    RecordProperty("built_ms", std::to_string(1e3 * built_s));
    for (const double each_s : {taken_s, refused_s, built_s})
        EXPECT_LT(each_s, 0.5);  // a machine under load; drawing.h tells what it takes
}

}  // namespace
}  // namespace touchline
