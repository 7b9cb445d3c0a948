#include "tests/exact/orientation.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace touchline::exact {
namespace {

TEST(Orientation, TellsLeftFromRightOneUlpFromTheLine) {
    const Position a{0.1, 0.1};
    const Position b{0.3, 0.3};
    const double up = std::nextafter(0.2, 1.0);
    EXPECT_EQ(orientation(a, b, {0.2, up}), 1);
    EXPECT_EQ(orientation(a, b, {up, 0.2}), -1);
    EXPECT_EQ(orientation(a, b, {0.2, 0.2}), 0);
}

TEST(Orientation, SegmentsMeetAtAnEndAndNotBesideIt) {
    EXPECT_TRUE(meet({0, 0}, {1, 0}, {0.5, 0}, {0.5, 1}));
    EXPECT_FALSE(meet({0, 0}, {1, 0}, {0.5, 1e-300}, {0.5, 1}));
    EXPECT_TRUE(meet({0, 0}, {1, 1}, {0, 1}, {1, 0}));
    EXPECT_FALSE(meet({0, 0}, {1, 0}, {2, 0}, {3, 0}));
}

}  // namespace
}  // namespace touchline::exact
