#include "tests/lab/bench/curve/filters.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace touchline::bench {
namespace {

std::vector<Position> random_points(std::size_t count) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
    std::vector<Position> points(count);
    for (Position& p : points) p = {coordinate(random), coordinate(random)};
    return points;
}

/// Returns the largest detail away from the seam if the points are a polynomial of this degree.
double largest_detail(Filter filter, int degree) {
    constexpr std::size_t count = 64;
    std::vector<Position> points(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double u = static_cast<double>(i) / static_cast<double>(count);
        points[i] = {std::pow(u, degree), 1.0};
    }
    const WaveletLevel level = analyze_closed(filter, points);
    double largest = 0.0;
    for (std::size_t k = 4; k + 4 < level.details.size(); ++k) {
        largest = std::max(largest, std::abs(level.details[k].x));
    }
    return largest;
}

TEST(Filters, InvertToRounding) {
    for (const Filter filter : all_filters) {
        for (const std::size_t count : {16U, 64U, 510U}) {
            const auto points = random_points(count);
            const auto back = synthesize_closed(filter, analyze_closed(filter, points));
            ASSERT_EQ(back.size(), count);
            for (std::size_t i = 0; i < count; ++i) {
                EXPECT_LE(norm(back[i] - points[i]), 1e-12) << name_of(filter);
            }
        }
    }
}

TEST(Filters, HaveTheirVanishingMomentsAndNoMore) {
    struct Known {
        Filter filter;
        int moments;
    };

    for (const Known known : {Known{Filter::haar, 1}, Known{Filter::cdf_5_3, 2},
                              Known{Filter::cdf_9_7, 4}, Known{Filter::paper_13_7, 4}}) {
        for (int degree = 0; degree < known.moments; ++degree) {
            EXPECT_LE(largest_detail(known.filter, degree), 1e-12)
                << name_of(known.filter) << ' ' << degree;
        }
        EXPECT_GE(largest_detail(known.filter, known.moments), 1e-7) << name_of(known.filter);
    }
}

TEST(Filters, LowPassesHaveGain1SoThatScalingCoefficientsArePoints) {
    const std::vector<Position> still(32, Position{0.3, -0.7});
    for (const Filter filter : all_filters) {
        for (const Position p : analyze_closed(filter, still).points) {
            EXPECT_LE(norm(p - still[0]), 1e-12) << name_of(filter);
        }
    }
}

TEST(Filters, AHaarPointStandsForTheMiddleOfWhatItAverages) {
    std::vector<Position> line(32);
    for (std::size_t i = 0; i < line.size(); ++i) line[i].x = static_cast<double>(i);
    std::vector<Position> coarse = line;
    for (int level = 1; level <= 3; ++level) {
        coarse = analyze_closed(Filter::haar, coarse).points;
        EXPECT_DOUBLE_EQ(coarse[0].x, first_parameter(Filter::haar, level));
    }
}

TEST(Filters, DenoisingLeavesASmoothCurveNearlyAsItIsAndTakesNoiseAway) {
    constexpr std::size_t count = 512;
    constexpr double sigma_m = 2e-4;
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0.0, sigma_m);
    std::vector<Position> clean(count);
    std::vector<Position> noisy(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = 6.283185307179586 * static_cast<double>(i) / count;
        clean[i] = {0.03 * std::cos(angle), 0.03 * std::sin(angle)};
        noisy[i] = clean[i] + Position{noise(random), noise(random)};
    }
    const auto mean_square = [&](const std::vector<Position>& points) {
        double sum = 0.0;
        for (std::size_t i = 0; i < count; ++i) {
            const double off = norm(points[i] - clean[i]);
            sum += off * off;
        }
        return sum / count;
    };
    for (const Filter filter : {Filter::paper_13_7, Filter::cdf_5_3, Filter::cdf_9_7}) {
        EXPECT_LE(mean_square(denoised(filter, noisy, sigma_m, 4)), 0.3 * mean_square(noisy))
            << name_of(filter);
    }
}

std::vector<Position> wave(std::size_t count) {
    std::vector<Position> points;
    for (std::size_t i = 0; i < count; ++i) {
        const double u = static_cast<double>(i);
        points.push_back({1e-3 * u, 2e-3 * std::sin(0.3 * u) + 5e-4 * std::sin(1.7 * u)});
    }
    return points;
}

TEST(Simplifiers, GiveTheCountAskedAndKeepTheEnds) {
    const auto points = wave(100);
    for (const auto& simplify : {douglas_peucker, visvalingam}) {
        for (const std::size_t count : {2U, 3U, 25U, 99U, 100U}) {
            const auto kept = simplify(points, count);
            ASSERT_EQ(kept.size(), count);
            EXPECT_EQ(kept.front(), 0U);
            EXPECT_EQ(kept.back(), 99U);
            for (std::size_t i = 1; i < kept.size(); ++i) EXPECT_LT(kept[i - 1], kept[i]);
        }
    }
}

TEST(Simplifiers, KeepTheCornerOfARoof) {
    const std::vector<Position> roof{{0, 0}, {1, 0.99}, {2, 2.02}, {3, 3}, {4, 2.01}, {5, 0}};
    EXPECT_EQ(douglas_peucker(roof, 3), (std::vector<std::size_t>{0, 3, 5}));
    EXPECT_EQ(visvalingam(roof, 3), (std::vector<std::size_t>{0, 3, 5}));
}

TEST(Simplifiers, DifferWhereASpikeIsFarButSmall) {
    // The spike is the farthest point of its chord, the low hump the larger triangle.
    const std::vector<Position> line{{0, 0},  {4.9, 0}, {5, 1}, {5.1, 0},
                                     {10, 0}, {15, .5}, {20, 0}};
    EXPECT_EQ(douglas_peucker(line, 3), (std::vector<std::size_t>{0, 2, 6}));
    EXPECT_EQ(visvalingam(line, 4), (std::vector<std::size_t>{0, 4, 5, 6}));
}

}  // namespace

}  // namespace touchline::bench
