// Conservative advancement of one edge against one line: where the answer is known, and against
// samples of the move.

#include "haptics/probe/probe_front.h"
#include "tests/haptics/collision/trials.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace touchline {
namespace {

double share(const Segment& edge, const Segment& line, const ProbePose& from,
             const ProbeMove& move) {
    const Separation at = separation(ProbePlacement(from)(edge), line);
    return clear_share({edge, line, at}, ProbePlacement(from), move, 1e-6, 1.0);
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

TEST(ClearShare, KeepsItsDistanceUnderAnyPivot) {
    trials::Random random(11);
    const auto place = [&random](double size_m) {
        return Position{size_m * (random.unit() - 0.5), size_m * (random.unit() - 0.5)};
    };
    constexpr double keep_m = 1e-6;
    int cut = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        const Segment edge{place(0.01), place(0.01)};
        const Segment line{place(0.01), place(0.01)};
        const ProbePose from{0.0, 0.0, 6.0 * random.unit()};
        const ProbeMove move{place(2e-3), 0.4 * (random.unit() - 0.5), place(0.04)};
        const Separation at = separation(ProbePlacement(from)(edge), line);
        if (at.distance_m <= keep_m) continue;
        const double share = clear_share({edge, line, at}, ProbePlacement(from), move, keep_m, 1.0);
        cut += share < 1.0 ? 1 : 0;
        for (int k = 0; k <= 50; ++k) {
            const ProbePlacement then(from + (share * k / 50.0) * move);
            ASSERT_GE(separation(then(edge), line).distance_m, keep_m - 1e-12) << trial;
        }
    }
    EXPECT_GT(cut, 200);
}

}  // namespace
}  // namespace touchline
