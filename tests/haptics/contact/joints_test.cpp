// Where a line goes straight on, nothing may be felt: over a vertex, from one outline to the next,
// over a gap narrower than the proxy.
#include "haptics/contact/contact_machine.h"
#include "tests/haptics/scenes.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using scenes::map_of;
using scenes::outline;

ContactSettings settings_of(double radius_m, double friction = 0.0) {
    return {Mode::wall, 1000.0, friction, radius_m, 0.003};
}

TEST(Joint, ADiscThatComesDownBesideAVertexOfAStraightLineStaysAboveIt) {
    const Outline line = outline({{-0.002, 0}, {-0.001, 0}, {0, 0}, {0.001, 0}, {0.002, 0}}, false);
    for (const double radius : {0.0, 5e-5, 1e-3}) {
        const Scene scene = build_scene(map_of({line}), {}, radius).value();
        for (double aside = 1e-14; aside < 1e-7; aside *= 1.25) {
            for (const double x : {aside, -aside}) {
                ContactMachine machine;
                machine.reset(scene, {x, 0.002}, 0.0);
                const Position below{x, -0.001};
                const ContactReport report = machine.step(below, 0.0, settings_of(radius), {});
                ASSERT_GT(report.p_WP.y, 0.99 * radius) << radius << " " << x;
                ASSERT_NEAR(report.p_WP.x, x, 1e-12) << radius << " " << x;
            }
        }
    }
}

struct Slide {
    double farthest_lag_m = 0.0;  // of the proxy behind the hand
    double least_height_m = 1.0;
};

/// Slides 95 mm along 100 outlines of 1 mm end to end, 1 mm behind them, 50 um a step.
Slide slide_over(double gap_m, double radius_m, double friction) {
    std::vector<Outline> lines;
    for (int i = 0; i < 100; ++i) {
        lines.push_back(outline({{i * 1e-3, 0}, {(i + 1) * 1e-3 - gap_m, 0}}, false));
    }
    CurveOptions options;
    options.spacing_m = 2.5e-4;
    const Scene scene = build_scene(map_of(lines), options, radius_m).value();
    constexpr double deep_m = 1e-3;
    ContactMachine machine;
    machine.reset(scene, {5e-4, 3e-3}, 0.0);
    Slide slide;
    for (int k = 0; k < 1900; ++k) {
        const Position handle{5e-4 + k * 5e-5, -deep_m};
        const ContactReport report = machine.step(handle, 0.0, settings_of(radius_m, friction), {});
        const double held_m = friction * (deep_m + report.p_WP.y);
        slide.farthest_lag_m = std::max(slide.farthest_lag_m, handle.x - report.p_WP.x - held_m);
        slide.least_height_m = std::min(slide.least_height_m, report.p_WP.y);
    }
    return slide;
}

TEST(Joint, AHundredOutlinesEndToEndFeelLikeOneLine) {
    for (const double friction : {0.0, 0.3}) {
        for (const double radius : {0.0, 5e-5, 1e-3}) {
            const Slide slide = slide_over(0.0, radius, friction);
            EXPECT_LE(slide.farthest_lag_m, 1e-9) << radius << " " << friction;
            EXPECT_GE(slide.least_height_m, 0.999 * std::max(radius, contact_skin_m))
                << radius << " " << friction;
        }
    }
}

TEST(Joint, GapsNarrowerThanTheProxyAreSlidOver) {
    for (const double friction : {0.0, 0.3}) {
        for (const double radius : {5e-5, 1e-3}) {
            for (const double gap : {1e-12, 1e-9, 1e-7, 1e-6}) {
                const Slide slide = slide_over(gap, radius, friction);
                EXPECT_LE(slide.farthest_lag_m, gap + 1e-9) << radius << " " << gap;
                EXPECT_GE(slide.least_height_m, 0.999 * radius) << radius << " " << gap;
            }
        }
    }
}

}  // namespace
}  // namespace touchline
