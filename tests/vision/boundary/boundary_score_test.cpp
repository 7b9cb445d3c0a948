#include "tests/vision/boundary/boundary_score.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>
#include <rapidcheck/gtest.h>

namespace touchline::testing {
namespace {

const cv::Size map_size(200, 150);  // reach: 1.875 px

cv::Mat1b with_line(int y, int from = 20, int to = 180, uchar value = 255) {
    cv::Mat1b map(map_size, uchar{0});
    map(cv::Range(y, y + 1), cv::Range(from, to)) = value;
    return map;
}

TEST(BoundaryScore, TheSameLineScoresOne) {
    const BoundaryCounts counts = boundary_counts(with_line(70), 128, {with_line(70)});
    EXPECT_EQ(counts.f(), 1.0);
    EXPECT_EQ(counts.truth_all, 160.0);
}

TEST(BoundaryScore, AlineWithinReachScoresOneAndBeyondNothing) {
    EXPECT_EQ(boundary_counts(with_line(71), 128, {with_line(70)}).f(), 1.0);
    EXPECT_EQ(boundary_counts(with_line(72), 128, {with_line(70)}).f(), 0.0);
}

TEST(BoundaryScore, APixelOfTheTruthIsMatchedOnce) {
    cv::Mat1b two = with_line(69);
    two |= with_line(71);
    const BoundaryCounts counts = boundary_counts(two, 128, {with_line(70)});
    EXPECT_EQ(counts.recall(), 1.0);
    EXPECT_NEAR(counts.precision(), 0.5, 0.02);
}

TEST(BoundaryScore, RecallIsOfEveryAnnotatorPrecisionOfAny) {
    const BoundaryCounts counts = boundary_counts(
        with_line(70), 128, {with_line(70), with_line(100), with_line(70, 20, 100)});
    EXPECT_EQ(counts.precision(), 1.0);
    EXPECT_NEAR(counts.recall(), (160.0 + 0.0 + 80.0) / (160.0 + 160.0 + 80.0), 1e-9);
}

TEST(BoundaryScore, TheSweepFindsTheThresholdAboveTheClutter) {
    cv::Mat1b map = with_line(70, 20, 180, 150);
    map |= with_line(100, 20, 180, 130);
    BoundarySweep sweep;
    sweep.add(map, {with_line(70)});
    EXPECT_NEAR(sweep.automatic().f(), 2.0 / 3.0, 1e-6);
    EXPECT_EQ(sweep.best().f(), 1.0);
}

TEST(BoundaryScore, NothingFoundScoresNothing) {
    EXPECT_EQ(boundary_counts(cv::Mat1b(map_size, uchar{0}), 128, {with_line(70)}).f(), 0.0);
}

RC_GTEST_PROP(Thinned, KeepsPartsAndHolesAndLeavesThinLines, ()) {
    cv::Mat1b map(40, 50, uchar{0});
    const int shapes = *rc::gen::inRange(1, 6);
    for (int i = 0; i < shapes; ++i) {
        const cv::Point a(*rc::gen::inRange(5, 45), *rc::gen::inRange(5, 35));
        const cv::Point b(*rc::gen::inRange(5, 45), *rc::gen::inRange(5, 35));
        cv::line(map, a, b, 255, *rc::gen::inRange(1, 5));
    }
    const cv::Mat1b lines = thinned(map);
    cv::Mat labels;
    RC_ASSERT(cv::connectedComponents(map, labels) == cv::connectedComponents(lines, labels));
    cv::Mat1b beyond;
    cv::bitwise_and(lines, ~map, beyond);
    RC_ASSERT(cv::countNonZero(beyond) == 0);
    cv::Mat1b blocks;  // 3 x 3 pixels all set: not thin
    cv::erode(lines, blocks, cv::Mat());
    RC_ASSERT(cv::countNonZero(blocks) == 0);
}

}  // namespace
}  // namespace touchline::testing
