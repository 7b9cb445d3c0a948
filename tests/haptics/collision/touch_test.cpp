#include "haptics/collision/touch.h"

#include "tests/exact/orientation.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace touchline {
namespace {

// The point starts one skin from an edge's end, its foot 1e-8 of the edge before the end, and moves
// less than a tenth of a degree off the edge. Neither the side nor the end counted as touched, and
// it went through.
TEST(Touch, AGrazingMotionPastAnEndIsNotLetThrough) {
    const Segment segment{{-0x1.2e49b73c1038ap-6, 0x1.264d2a8f0267dp-5},
                          {-0x1.2e4a90ddba539p-6, 0x1.264ce20ca6d8p-5}};
    const Position from{-0x1.2e49b73d95bf6p-6, 0x1.264d2a90276d3p-5};
    const Position to{-0x1.dd2b7d71e3b7cp-6, 0x1.d7f531fe8506fp-6};
    ASSERT_TRUE(exact::meet(from, to, segment.a, segment.b));
    const auto found = touch(from, to, contact_skin_m, segment);
    ASSERT_TRUE(found);
    const Position stop = from + found->fraction * (to - from);
    EXPECT_FALSE(exact::meet(from, stop, segment.a, segment.b));
}

// From a skin beside an end, in every direction nearly along the edge.
TEST(Touch, WhatCrossesTheSegmentTouchesIt) {
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    int crossed = 0;
    for (int i = 0; i < 300000; ++i) {
        const double angle = 3.14159 * unit(engine);
        const Direction u{std::cos(angle), std::sin(angle)};
        const Position a{0.05 * unit(engine), 0.05 * unit(engine)};
        const double length_m = std::pow(10.0, -5.0 + 2.0 * unit(engine));
        const Segment segment{a, a + along<Position>(u, length_m)};
        const double lean = std::pow(10.0, -5.0 + 4.0 * unit(engine));
        const double before_m = contact_skin_m * std::pow(10.0, -2.0 + 3.0 * unit(engine));
        const double height_m = contact_skin_m * (1.0 + 0.1 * unit(engine));
        const Position from =
            a - along<Position>(u, before_m) + along<Position>(left_of(u), height_m);
        const Position to = from + along<Position>(u, 2.0 * length_m) -
                            along<Position>(left_of(u), lean * length_m);
        if (!exact::meet(from, to, segment.a, segment.b)) continue;
        ++crossed;
        const auto found = touch(from, to, contact_skin_m, segment);
        ASSERT_TRUE(found) << i;
        const Position stop = from + found->fraction * (to - from);
        ASSERT_FALSE(exact::meet(from, stop, segment.a, segment.b)) << i;
    }
    EXPECT_GT(crossed, 50000);
}

}  // namespace
}  // namespace touchline
