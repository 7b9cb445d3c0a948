#include "haptics/curve/curve_set.h"
#include "haptics/curve/spacing.h"
#include "haptics/curve/wavelet.h"
#include "tests/haptics/scenes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string_view>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

using scenes::map_of;

constexpr double turn = 2.0 * std::numbers::pi;

/// A shape that is known exactly, and where it was sampled.
struct Shape {
    std::string_view name;
    Outline outline;
};

Outline sampled(const std::function<Position(double)>& at, std::size_t count) {
    constexpr std::size_t fine = 8192;
    std::vector<Position> line;
    for (std::size_t i = 0; i <= fine; ++i) {
        line.push_back(at(turn * static_cast<double>(i % fine) / static_cast<double>(fine)));
    }
    line = resample(line, count);
    line.pop_back();
    return scenes::outline(std::move(line), true);
}

std::vector<Shape> shapes() {
    const auto fish = [](double u) {
        return Position{0.04 * std::cos(u) - 0.004 * std::cos(2 * u),
                        0.022 * std::sin(u) + 0.002 * std::sin(2 * u)};
    };
    return {{"circle", scenes::circle(0.03, 512)},
            {"fish", sampled(fish, 512)},
            {"square", scenes::square(0.05, 128)}};
}

/// Adds white noise to every point except the corners, which are known.
TactileMap with_noise(const Outline& outline, double sigma_m, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, sigma_m);
    Outline noisy = outline;
    const auto pins = find_pins({outline}, PinRule{})[0];
    for (std::size_t i = 0; i < noisy.points.size(); ++i) {
        const Position off{noise(random), noise(random)};
        if (std::find(pins.begin(), pins.end(), i) == pins.end()) noisy.points[i] += off;
    }
    return map_of({noisy});
}

struct Off {
    double rms_m = 0.0;      // distance of the rendered points from the true shape
    double slope_rad = 0.0;  // root mean square, weighted by length
};

/// Returns how far a level lies from the true shape.
Off off(const CurveSet& curves, int level, const Outline& truth) {
    double squares = 0.0;
    double slope_squares = 0.0;
    double length_m = 0.0;
    double count = 0.0;
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        for (int j = 0; j < curves.rendered_count(piece, level); ++j) {
            const Segment segment = curves.rendered_segment(piece, level, j);
            const Position middle = 0.5 * (segment.a + segment.b);
            double nearest_m = 1.0;
            Position along;
            for (std::size_t i = 0; i < truth.points.size(); ++i) {
                const Segment edge{truth.points[i], truth.points[(i + 1) % truth.points.size()]};
                const double distance_m = foot(middle, edge).distance_m;
                if (distance_m >= nearest_m) continue;
                nearest_m = distance_m;
                along = edge.b - edge.a;
            }
            const Position e = segment.b - segment.a;
            const double slope = std::atan2(cross(along, e), dot(along, e));
            squares += nearest_m * nearest_m;
            slope_squares += slope * slope * norm(e);
            length_m += norm(e);
            count += 1.0;
        }
    }
    return {std::sqrt(squares / count), std::sqrt(slope_squares / length_m)};
}

RC_GTEST_PROP(Denoise, ComesNearerTheTruthThanTheDataAndThanLevel1, ()) {
    const auto shape = *rc::gen::elementOf(shapes());
    const double sigma_m = 1e-5 * *rc::gen::inRange(5, 31);
    const auto seed = *rc::gen::arbitrary<unsigned>();
    const TactileMap noisy = with_noise(shape.outline, sigma_m, seed);
    CurveOptions options;
    // The wide spacing makes the data's points level 0. The default splits some edges in two.
    options.spacing_m = *rc::gen::element(0.005, 0.0);
    const CurveSet data = CurveSet::build(noisy, options).value();
    options.denoise_m = sigma_m;
    const CurveSet denoised = CurveSet::build(noisy, options).value();
    const Off raw = off(data, 0, shape.outline);
    const Off level_1 = off(data, 1, shape.outline);
    const Off clean = off(denoised, 0, shape.outline);
    RC_ASSERT(clean.rms_m <= 0.7 * raw.rms_m);
    RC_ASSERT(clean.rms_m <= 0.85 * level_1.rms_m);
    RC_ASSERT(clean.slope_rad <= 0.3 * raw.slope_rad);
    RC_ASSERT(clean.slope_rad <= 0.6 * level_1.slope_rad);
}

RC_GTEST_PROP(Denoise, PinsAreTheCornersAndStayOnTheDataAtEveryLevel, ()) {
    const double sigma_m = 1e-5 * *rc::gen::inRange(5, 31);
    const auto seed = *rc::gen::arbitrary<unsigned>();
    const TactileMap noisy = with_noise(scenes::square(0.05, 128), sigma_m, seed);
    CurveOptions options;
    options.denoise_m = sigma_m;
    const CurveSet denoised = CurveSet::build(noisy, options).value();
    const auto& vertices = noisy.outlines[0].points;
    RC_ASSERT(denoised.pieces().size() == 4U);  // noise is not taken for corners
    for (int piece = 0; piece < 4; ++piece) {
        const Position pin = denoised.points(piece, 0).front();
        RC_ASSERT(std::find(vertices.begin(), vertices.end(), pin) != vertices.end());
        for (int level = 1; level <= denoised.coarsest(); ++level) {
            RC_ASSERT(denoised.points(piece, level).front() == pin);
        }
    }
    RC_ASSERT(denoised.reports()[0].shrunk_rms_m >= 0.3 * sigma_m);
    RC_ASSERT(denoised.reports()[0].shrunk_max_m <= 10.0 * sigma_m);
}

TEST(Denoise, NoiseGainsAreThoseOfImpulses) {
    constexpr std::size_t count = 512;
    constexpr std::size_t levels = 4;
    std::vector<double> squares(levels, 0.0);
    for (std::size_t i = 0; i < count; ++i) {
        std::vector<Position> impulse(count);
        impulse[i].x = 1.0;
        const Decomposition curve = decompose(std::move(impulse), {count, 1, true}, levels);
        for (std::size_t k = 0; k < levels; ++k) squares[k] += std::pow(curve.details[k][7].x, 2);
    }
    const auto gains = noise_gains(levels);
    for (std::size_t k = 0; k < levels; ++k) EXPECT_NEAR(gains[k], std::sqrt(squares[k]), 1e-12);
}

TEST(Denoise, LevelsThatAreMostlySignalStayAsTheyAre) {
    std::vector<Position> details(64, Position{3e-4, 0.0});
    const auto before = details;
    denoise_level(details, 1e-4, 512);
    EXPECT_EQ(details, before);
    denoise_level(details, 2e-4, 512);
    EXPECT_EQ(details, std::vector<Position>(64));
}

}  // namespace
}  // namespace touchline
