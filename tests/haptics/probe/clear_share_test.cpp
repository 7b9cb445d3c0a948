// Conservative advancement of one edge against one line, where the answer is known.

#include "haptics/probe/probe_front.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace touchline {
namespace {

double share(const Segment& edge, const Segment& line, const ProbePose& from,
             const ProbeMove& move) {
    const Separation at = separation(ProbePlacement(from)(edge), line);
    return clear_share({edge, line, at}, from, ProbePlacement(from), move, 1e-6, 1.0);
}

TEST(ClearShare, OfAStraightFallEndsAtTheDistanceKept) {
    const Segment edge{{-0.01, 0.0}, {0.01, 0.0}};
    const Segment line{{-0.05, 0.0}, {0.05, 0.0}};
    EXPECT_NEAR(share(edge, line, {0.0, 0.002, 0.0}, {{0.0, -0.01}, 0.0}), (0.002 - 1e-6) / 0.01,
                1e-6);
}

TEST(ClearShare, OfATurnEndsWhereTheTipMeetsTheLine) {
    const Segment edge{{0.0, 0.0}, {0.01, 0.0}};
    const Segment line{{-0.05, 0.005}, {0.05, 0.005}};
    const double at = share(edge, line, {}, {{}, std::numbers::pi / 2.0});
    EXPECT_NEAR(std::sin(at * std::numbers::pi / 2.0), (0.005 - 1e-6) / 0.01, 1e-6);
}

TEST(ClearShare, OfATurnPastAnEndEndsAtTheEnd) {
    const Segment edge{{0.0, 0.0}, {0.01, 0.0}};
    const Segment line{{0.004, 0.004}, {0.05, 0.05}};  // its end at 45 degrees
    const double at = share(edge, line, {}, {{}, std::numbers::pi / 2.0});
    EXPECT_NEAR(at, 0.5, 1e-3);
    EXPECT_LT(at, 0.5);
}

TEST(ClearShare, OfAMotionBesideTheLineIsWhole) {
    const Segment edge{{0.0, 0.0}, {0.01, 0.0}};
    const Segment line{{0.0, -1e-6}, {0.01, -1e-6}};
    EXPECT_EQ(share(edge, line, {}, {{0.005, 0.0}, 0.0}), 1.0);
    EXPECT_EQ(share(edge, line, {}, {{0.0, 0.05}, 0.0}), 1.0);
}

}  // namespace
}  // namespace touchline
