// The perceptual floor against the thresholds of touch and the error of each level.
#include "haptics/curve/curve_set.h"
#include "tests/haptics/scenes.h"

#include <cmath>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

using scenes::circle;
using scenes::map_of;
using scenes::square;

CurveSet curves_of(const TactileMap& map) {
    return CurveSet::build(map, {}).value();
}

TEST(DetectionThreshold, IsTheLawsTable) {
    // Width and height in mm.
    for (const auto& [width, height] : {std::pair{2.0, 0.016},
                                        {4.0, 0.039},
                                        {8.0, 0.096},
                                        {16.0, 0.24},
                                        {32.0, 0.58},
                                        {64.0, 1.4},
                                        {240.0, 8.0}}) {
        EXPECT_NEAR(detection_threshold_m(1e-3 * width) * 1e3, height, 0.03 * height) << width;
    }
}

/// Whether no outline of the level can be told from level 0, by the reported errors. With `slack`
/// above 1 false is certain, below 1 true is certain.
bool is_untold(const CurveSet& curves, int outlines, int level, double slack) {
    const double wavelength_m = 4.0 * curves.finest_spacing_m() * std::exp2(level);
    for (int outline = 0; outline < outlines; ++outline) {
        const LevelError error = level_error(curves, outline, level);
        const bool is_near = error.hausdorff_m <= slack * 0.5 * detection_threshold_m(wavelength_m);
        const bool is_parallel = error.slope_max_rad <= slack * std::numbers::pi / 36.0;
        if (!is_near || !is_parallel) return false;
    }
    return true;
}

/// A closed curve of one smooth piece, rough by up to 50 um.
Outline rough_ring(double radius_m, int points, double roughness_m, unsigned waves) {
    Outline ring = circle(radius_m, points);
    for (std::size_t i = 0; i < ring.points.size(); ++i) {
        const double phase = 2.0 * std::numbers::pi * static_cast<double>(waves * i) / points;
        ring.points[i] = (1.0 + roughness_m / radius_m * std::sin(phase)) * ring.points[i];
    }
    return ring;
}

RC_GTEST_PROP(PerceptLevel, IsTheLastBeforeTheFirstThatCanBeTold, ()) {
    const auto one = [] {
        return rough_ring(1e-3 * *rc::gen::inRange(5, 40), *rc::gen::inRange(60, 3000),
                          1e-6 * *rc::gen::element(0, 0, 1, 3, 10, 50),
                          static_cast<unsigned>(*rc::gen::inRange(2, 60)));
    };
    const CurveSet curves = curves_of(map_of({one(), one()}));
    const int level = percept_level(curves);
    RC_ASSERT(level <= curves.coarsest());
    for (int finer = 1; finer <= level; ++finer) RC_ASSERT(is_untold(curves, 2, finer, 1.0 + 1e-9));
    if (level < curves.coarsest()) RC_ASSERT(!is_untold(curves, 2, level + 1, 1.0 - 1e-9));
}

TEST(PerceptLevel, OfADenseSmoothCircleIsFarAboveLevel0AndTheSameLengthAtAnyDensity) {
    const CurveSet dense = curves_of(map_of({circle(0.02, 1024)}));
    const CurveSet denser = curves_of(map_of({circle(0.02, 4096)}));
    EXPECT_GE(percept_level(dense), 3);
    EXPECT_EQ(percept_level(denser), percept_level(dense) + 2);
}

TEST(PerceptLevel, StraightSidesBoundNothing) {
    const CurveSet curves = curves_of(map_of({square(0.04, 64)}));
    EXPECT_GT(curves.coarsest(), 0);
    EXPECT_EQ(percept_level(curves), curves.coarsest());
}

TEST(PerceptLevel, OneOutlineThatWouldBeToldKeepsTheWholeSceneFine) {
    Outline wavy = rough_ring(0.01, 256, 2e-4, 40);
    const CurveSet curves = curves_of(map_of({circle(0.03, 1024), wavy}));
    EXPECT_EQ(percept_level(curves), 0);
}

TEST(PerceptLevel, OfNothingIsLevel0) {
    EXPECT_EQ(percept_level(curves_of(map_of({}))), 0);
}

}  // namespace
}  // namespace touchline
