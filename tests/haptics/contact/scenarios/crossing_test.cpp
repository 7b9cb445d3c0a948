// S08: a figure of eight whose strands cross at 10 degrees. There is no reference run: the proxy
// stays in the sector that it came from.
#include "tests/haptics/contact/scenarios/runner.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace touchline::scenarios {
namespace {

constexpr double lean_rad = 5.0 * pi / 180.0;  // of each strand to the x axis
constexpr double strand_mm = 20.0;             // from the crossing to where a lobe begins

/// Two straight strands through the origin, joined smoothly by arcs on both sides.
Polyline figure_of_eight() {
    constexpr int arc_edges = 24;
    const double centre_mm = strand_mm / std::cos(lean_rad);
    const double radius_mm = strand_mm * std::tan(lean_rad);
    Polyline line{{}, true};
    for (const double side : {1.0, -1.0}) {
        // The right lobe clockwise from above, then the left lobe counter-clockwise from above.
        for (int i = 0; i <= arc_edges; ++i) {
            const double angle = (0.5 * pi + lean_rad) * (1.0 - 2.0 * i / arc_edges);
            line.points_mm.push_back(
                {side * (centre_mm + radius_mm * std::cos(angle)), radius_mm * std::sin(angle)});
        }
    }
    return line;
}

/// Names the sector of p: its side of each strand.
std::pair<bool, bool> sector(Position p) {
    const Position rising{std::cos(lean_rad), std::sin(lean_rad)};
    const Position falling{std::cos(lean_rad), -std::sin(lean_rad)};
    return {cross(rising, p) > 0.0, cross(falling, p) > 0.0};
}

/// The parameters: the direction from the crossing into the sector; whether the line runs
/// backwards; whether both strands have a vertex there.
class ScenarioS08 : public testing::TestWithParam<std::tuple<Position, bool, bool>> {};

TEST_P(ScenarioS08, AtACrossingTheProxyStaysInItsSector) {
    const auto [towards, is_reversed, is_at_vertex] = GetParam();
    Polyline line = figure_of_eight();
    if (is_reversed) std::reverse(line.points_mm.begin(), line.points_mm.end());
    CurveOptions options;
    // Both strands, of 40 mm, in 160 parts or in 161.
    options.spacing_m = 40 * mm / (is_at_vertex ? 160 : 161);
    const Scene scene = scene_of({line}, CommonSetUp{}.contact.radius_m, options);
    // Like S02: to 5 mm past the crossing, 2 mm to both sides for a second, a rest.
    const auto press = [towards = towards](double t) -> Intention {
        constexpr double omega = 2.0 * pi * 3.0;
        const bool is_wiggling = t > 0.5 && t < 1.5;
        const double depth_m = 12 * mm - 17 * mm * std::min(t / 0.5, 1.0);
        const double aside_m = is_wiggling ? 2 * mm * std::sin(omega * t) : 0.0;
        const Position at = depth_m * towards + aside_m * left_of(towards);
        const double aside_speed = is_wiggling ? 2 * mm * omega * std::cos(omega * t) : 0.0;
        return {at, along<Velocity>(towards, t < 0.5 ? -34 * mm : 0.0) +
                        along<Velocity>(left_of(towards), aside_speed)};
    };
    const ScenarioRun felt = run(scene, press, 2.5);
    const auto escapes = std::count_if(felt.proxy.begin(), felt.proxy.end(),
                                       [&](Position p) { return sector(p) != sector(towards); });
    EXPECT_EQ(escapes, 0);
    EXPECT_GT(largest_force_N(felt), 1.0);
    EXPECT_LT(tail_peak_to_peak_m(felt), 1e-6);
    RecordProperty("force_N", fmt::format("{:.4f}", largest_force_N(felt)));
    RecordProperty("jump_N", fmt::format("{:.4f}", largest_jump(felt).size_N));
    expect_sound(felt.watch);
}

INSTANTIATE_TEST_SUITE_P(SectorsDirectionsAndPlaces, ScenarioS08,
                         testing::Combine(testing::Values(Position{1.0, 0.0}, Position{0.0, 1.0},
                                                          Position{-1.0, 0.0}, Position{0.0, -1.0}),
                                          testing::Bool(), testing::Bool()));

}  // namespace
}  // namespace touchline::scenarios
