#include "haptics/curve/wavelet.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

std::vector<Position> random_points(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(-0.05, 0.05);
    std::vector<Position> points(count);
    for (Position& p : points) p = {coordinate(random), coordinate(random)};
    return points;
}

double largest_difference(const std::vector<Position>& a, const std::vector<Position>& b) {
    double largest = a.size() == b.size() ? 0.0 : 1.0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        largest = std::max(largest, norm(a[i] - b[i]));
    }
    return largest;
}

/// A cubic in the parameter, in both coordinates.
Position cubic(double u) {
    return {1e-3 * (1.0 + u * (2.0 + u * (-0.3 + 0.01 * u))),
            1e-3 * (2.0 - u * (1.0 + u * (0.1 - 0.004 * u)))};
}

std::vector<Position> cubic_points(std::size_t segments) {
    std::vector<Position> points;
    for (std::size_t i = 0; i <= segments; ++i) points.push_back(cubic(static_cast<double>(i)));
    return points;
}

RC_GTEST_PROP(Wavelet, IsInvertedToRoundingOnAnyCurve, ()) {
    const auto segments = *rc::gen::inRange<std::size_t>(8, 400);
    const auto is_closed = *rc::gen::arbitrary<bool>();
    const auto seed = *rc::gen::arbitrary<unsigned>();
    const auto levels = *rc::gen::inRange(1, 4);
    const auto points = random_points(segments + (is_closed ? 0 : 1), seed);
    if (segments >> levels < 4) return;
    const auto back = reconstruct(decompose(points, {segments, 1, is_closed}, levels));
    RC_ASSERT(largest_difference(points, back) <= 1e-12 * 0.1);
}

TEST(Wavelet, CubicsAreReproducedAtEveryLevelUpToTheEnds) {
    for (const std::size_t segments : {64U, 61U, 100U, 33U}) {
        std::vector<Position> points = cubic_points(segments);
        for (std::size_t stride = 1; segments / stride >= 8; stride *= 2) {
            const WaveletLevel coarse = analyze(points, {segments, stride, false});
            for (const Position d : coarse.details) EXPECT_LE(norm(d), 1e-13) << segments;
            for (std::size_t i = 0; i < coarse.points.size(); ++i) {
                const double u = static_cast<double>(std::min(2 * stride * i, segments));
                EXPECT_LE(norm(coarse.points[i] - cubic(u)), 1e-13) << segments << " " << i;
            }
            points = coarse.points;
        }
    }
}

TEST(Wavelet, EqualsThePaperSThirteenTapFilter) {
    constexpr std::array<double, 7> half{348, 144, -63, -16, 18, 0, -1};
    const auto points = random_points(64, 7);
    const auto coarse = analyze(points, {64, 1, true}).points;
    for (std::size_t i = 0; i < coarse.size(); ++i) {
        Position filtered = (half[0] / 512) * points[2 * i];
        for (std::size_t k = 1; k < half.size(); ++k) {
            filtered +=
                (half[k] / 512) * (points[(2 * i + k) % 64] + points[(2 * i + 64 - k) % 64]);
        }
        EXPECT_LE(norm(filtered - coarse[i]), 1e-16);
    }
}

/// Returns moment p of the wavelet of detail k, about its own centre.
double moment(std::size_t segments, std::size_t k, int p) {
    const CurveShape shape{segments, 1, false};
    WaveletLevel level = analyze(std::vector<Position>(segments + 1), shape);
    level.details[k] = {1.0, 0.0};
    const auto wavelet = synthesize(level, shape);
    double sum = 0.0;
    for (std::size_t i = 0; i < wavelet.size(); ++i) {
        sum += std::pow(static_cast<double>(i) - static_cast<double>(2 * k + 1), p) * wavelet[i].x;
    }
    return sum;
}

TEST(Wavelet, HasFourPrimalMomentsFromFourSamplesInsideAnOpenEnd) {
    // Detail k changes the coarse samples k - 1 ... k + 2; the four at an end feed a one-sided
    // prediction.
    constexpr std::size_t segments = 64;
    constexpr std::size_t coarse = segments / 2;
    for (std::size_t k = 5; k + 2 <= coarse - 4; ++k) {
        for (int p = 0; p < 4; ++p)
            EXPECT_NEAR(moment(segments, k, p), 0.0, 1e-11) << k << " " << p;
    }
    EXPECT_GT(std::abs(moment(segments, 1, 0)), 1e-3);
}

/// Takes a rough outline in various numbers of segments, so that some end in a very short one.
TEST(Wavelet, CoarseLevelsStayBesideTheCurveWhereTheLastSegmentIsShort) {
    for (const std::size_t segments : {513U, 514U, 520U, 1025U, 4097U, 4100U, 4609U}) {
        for (const bool is_closed : {false, true}) {
            std::vector<Position> points = random_points(segments + (is_closed ? 0 : 1), 5);
            for (std::size_t i = 0; i < points.size(); ++i) {
                const double turn =
                    2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(segments);
                points[i] = 0.05 * Position{std::cos(turn), std::sin(turn)} + 0.02 * points[i];
            }
            CurveShape shape{segments, 1, is_closed};
            for (std::size_t count = segments; count >= 8; count = coarser_count(count)) {
                points = analyze(points, shape).points;
                shape.stride *= 2;
                for (const Position p : points) {
                    ASSERT_LE(norm(p), 0.055)
                        << segments << " " << shape.stride << " " << is_closed;
                }
            }
        }
    }
}

TEST(Wavelet, EndsOfAnOpenCurveStayWhereTheyAre) {
    const auto points = random_points(78, 3);
    const auto coarse = analyze(points, {77, 1, false}).points;
    EXPECT_EQ(coarse.front(), points.front());
    EXPECT_EQ(coarse.back(), points.back());
}

TEST(Wavelet, DetailsOfASmoothCurveShrinkSixteenfoldALevel) {
    std::vector<Position> points;
    for (int i = 0; i < 512; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 512.0;
        points.push_back({0.03 * std::cos(angle), 0.03 * std::sin(angle)});
    }
    const Decomposition curve = decompose(points, {512, 1, true}, 4);
    for (std::size_t level = 0; level < 3; ++level) {
        const double ratio = norm(curve.details[level + 1][5]) / norm(curve.details[level][5]);
        EXPECT_NEAR(ratio, 16.0, 1.6);
    }
}

TEST(Shrink, HalfTheNoiseGoesAndTheCircleStays) {
    std::mt19937 random(11);
    std::normal_distribution<double> noise(0.0, 1e-4);
    std::vector<Position> clean;
    std::vector<Position> noisy;
    for (int i = 0; i < 512; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 512.0;
        clean.push_back({0.03 * std::cos(angle), 0.03 * std::sin(angle)});
        noisy.push_back(clean.back() + Position{noise(random), noise(random)});
    }
    Decomposition curve = decompose(noisy, {512, 1, true}, 5);
    denoise(curve, 1e-4);
    const auto smooth = reconstruct(curve);
    double before = 0.0;
    double after = 0.0;
    for (std::size_t i = 0; i < clean.size(); ++i) {
        before += std::pow(norm(noisy[i] - clean[i]), 2);
        after += std::pow(norm(smooth[i] - clean[i]), 2);
    }
    EXPECT_LT(std::sqrt(after), 0.5 * std::sqrt(before));
}

TEST(Shrink, KeepsTheLargestDetailsAndNoMoreThanAsked) {
    Decomposition curve = decompose(random_points(128, 5), {128, 1, true}, 3);
    const double threshold = detail_threshold({&curve, 1}, 0.25);
    drop_details(curve, threshold);
    std::size_t kept = 0;
    std::size_t all = 0;
    for (const auto& level : curve.details) {
        all += level.size();
        for (const Position d : level) kept += norm(d) > 0.0 ? 1U : 0U;
    }
    EXPECT_EQ(kept, all / 4);
    EXPECT_EQ(detail_threshold({&curve, 1}, 1.0), 0.0);
}

}  // namespace
}  // namespace touchline
