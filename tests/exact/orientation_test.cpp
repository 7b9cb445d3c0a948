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

TEST(Orientation, HoldsWhereProductsOfDoublesUnderflowOrLoseTheirSum) {
    const double least = std::numeric_limits<double>::denorm_min();
    EXPECT_EQ(orientation({0, 0}, {least, 0}, {0, least}), 1);
    EXPECT_EQ(orientation({0, 0}, {1e300, 1e300}, {1, 1 + 0x1p-52}), 1);
    EXPECT_EQ(orientation({1, 1}, {1 + 0x1p-52, 1 + 0x1p-52}, {-1e300, -1e300}), 0);
    EXPECT_EQ(orientation({1, 1}, {1 + 0x1p-52, 1 + 0x1p-52}, {least, 0}), -1);
}

TEST(Orientation, SegmentsMeetAtAnEndAndNotBesideIt) {
    EXPECT_TRUE(meet({0, 0}, {1, 0}, {0.5, 0}, {0.5, 1}));
    EXPECT_FALSE(meet({0, 0}, {1, 0}, {0.5, 1e-300}, {0.5, 1}));
    EXPECT_TRUE(meet({0, 0}, {1, 1}, {0, 1}, {1, 0}));
    EXPECT_FALSE(meet({0, 0}, {1, 0}, {2, 0}, {3, 0}));
}

TEST(Orientation, SegmentsCrossInsideAndNotWhereTheyTouch) {
    EXPECT_TRUE(cross_inside({0, 0}, {1, 1}, {0, 1}, {1, 0}));
    EXPECT_TRUE(cross_inside({0, 0}, {1, 0}, {0.5, -1e-300}, {0.5, 1}));
    EXPECT_FALSE(cross_inside({0, 0}, {1, 0}, {0.5, 0}, {0.5, 1}));
    EXPECT_FALSE(cross_inside({0, 0}, {1, 0}, {0.5, 1e-300}, {0.5, 1}));
    EXPECT_FALSE(cross_inside({0, 0}, {2, 0}, {1, 0}, {3, 0}));
}

TEST(FirstMeeting, IsTheExactShareRoundedToNearest) {
    const Segment upright{{0.0, -1.0}, {0.0, 1.0}};
    EXPECT_EQ(first_meeting({-1, 0}, {2, 0}, upright), 1.0 / 3.0);
    EXPECT_EQ(first_meeting({-1, 0.5}, {6, 0.25}, upright), 1.0 / 7.0);
    EXPECT_EQ(first_meeting({-2, 0}, {0, 1}, upright), 1.0);
    EXPECT_EQ(first_meeting({0, 1}, {3, 1}, upright), 0.0);
    EXPECT_FALSE(first_meeting({0, std::nextafter(1.0, 2.0)}, {3, 1}, upright));
    EXPECT_FALSE(first_meeting({-2, 0}, {-1e-300, 0}, upright));
}

TEST(FirstMeeting, AlongTheSegmentIsWhereTheyFirstTouch) {
    const Segment level{{0.0, 0.0}, {3.0, 0.0}};
    EXPECT_EQ(first_meeting({-1, 0}, {9, 0}, level), 0.1);
    EXPECT_EQ(first_meeting({7, 0}, {2, 0}, level), 0.8);
    EXPECT_EQ(first_meeting({2, 0}, {7, 0}, level), 0.0);
    EXPECT_EQ(first_meeting({4, 0}, {3, 0}, level), 1.0);
    EXPECT_FALSE(first_meeting({4, 0}, {7, 0}, level));
    const Segment steep{{1.0, 2.0}, {2.0, 4.0}};
    EXPECT_EQ(first_meeting({0, 0}, {4, 8}, steep), 0.25);
}

TEST(FirstMeeting, WayOrSegmentMayBeOnePoint) {
    const Segment level{{0.0, 0.0}, {3.0, 0.0}};
    EXPECT_EQ(first_meeting({1, 0}, {1, 0}, level), 0.0);
    EXPECT_FALSE(first_meeting({1, 1e-300}, {1, 1e-300}, level));
    const Segment point{{1.0, 1.0}, {1.0, 1.0}};
    EXPECT_EQ(first_meeting({0, 0}, {4, 4}, point), 0.25);
    EXPECT_EQ(first_meeting({1, 1}, {1, 1}, point), 0.0);
    EXPECT_FALSE(first_meeting({0, 0}, {4, 5}, point));
}

}  // namespace
}  // namespace touchline::exact
