// S07 and S09: the level of resolution changes while the hand presses. The levels are the curve's
// own, set through the machine's ordinary argument.
#include "tests/exact/orientation.h"
#include "tests/haptics/contact/scenarios/runner.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace touchline::scenarios {
namespace {

std::vector<Segment> rendered(const CurveSet& curves, int piece, double level) {
    std::vector<Segment> segments;
    for (int j = 0; j < curves.rendered_count(piece, level); ++j) {
        segments.push_back(curves.rendered_segment(piece, level, j));
    }
    return segments;
}

// S07: two strands 0.4 mm apart, bent apart or alike. They never cross, whatever level is wanted;
// the coarsest levels of those bent alike would.

/// Returns the height of a strand that runs from left to right.
double height_at(const std::vector<Segment>& strand, double x) {
    for (const Segment& s : strand) {
        if (s.a.x <= x && x <= s.b.x) {
            return s.a.y + (x - s.a.x) / (s.b.x - s.a.x) * (s.b.y - s.a.y);
        }
    }
    ADD_FAILURE() << "no strand at " << x;
    return 0.0;
}

/// Whether some segment of one strand meets some segment of the other.
bool do_cross(const CurveSet& curves, double level) {
    const auto one = rendered(curves, 0, level);
    const auto other = rendered(curves, 1, level);
    return std::any_of(one.begin(), one.end(), [&](const Segment& s) {
        return std::any_of(other.begin(), other.end(),
                           [&](const Segment& t) { return exact::meet(s.a, s.b, t.a, t.b); });
    });
}

struct Strands {
    Polyline upper, lower;
    double middle_per_mm;  // the curve half way between: y = this x^2
    bool does_coarsest_cross;
};

Strands mirrored() {
    return {strand(1.0, 0.0, -20.0), strand(-1.0, 0.0, -20.0), 0.0, false};
}

/// Bent alike, the vertices of one beside the middles of the other's edges.
Strands nested() {
    return {strand(1.0, 0.0, -15.0), strand(1.0, -0.4, -20.0), 0.02, true};
}

class ScenarioS07 : public testing::TestWithParam<Strands> {};

TEST_P(ScenarioS07, BetweenTwoStrandsTheProxyStaysInItsCellWhateverLevelIsWanted) {
    const Strands& strands = GetParam();
    CurveOptions options;
    options.spacing_m = 1 * mm;  // no edge is split
    const TactileMap map = map_of({strands.upper, strands.lower});
    const Scene scene = build_scene(map, options, CommonSetUp{}.contact.radius_m).value();
    const CurveSet every_level = CurveSet::build(map, options).value();
    const double coarsest = every_level.coarsest();
    ASSERT_FALSE(do_cross(scene.curves, 0.0));
    ASSERT_EQ(do_cross(every_level, coarsest), strands.does_coarsest_cross);
    ASSERT_EQ(scene.curves.coarsest() < coarsest, strands.does_coarsest_cross);
    // 50 mm/s along the middle, 3 mm to both sides at 3 Hz.
    const Trajectory trace = [&](double t) -> Intention {
        constexpr double omega = 2.0 * pi * 3.0;
        const double x_mm = -13.0 + 50.0 * t;
        const double slope = 2.0 * strands.middle_per_mm * x_mm;
        return {{x_mm * mm, (strands.middle_per_mm * x_mm * x_mm + 3.0 * std::sin(omega * t)) * mm},
                {50 * mm, 50 * mm * slope + 3 * mm * omega * std::cos(omega * t)}};
    };
    const ScenarioRun felt =
        run(scene, trace, 0.6, {}, [&](double t) { return t < 0.05 || t > 0.45 ? 0.0 : coarsest; });
    int out_of_cell = 0;
    for (std::size_t k = 0; k < felt.proxy.size(); ++k) {
        const Position p = felt.proxy[k];
        const bool is_inside = p.y < height_at(rendered(scene.curves, 0, felt.level[k]), p.x) &&
                               p.y > height_at(rendered(scene.curves, 1, felt.level[k]), p.x);
        out_of_cell += is_inside ? 0 : 1;
    }
    EXPECT_EQ(out_of_cell, 0);
    for (const double level : std::set<double>(felt.level.begin(), felt.level.end())) {
        EXPECT_FALSE(do_cross(scene.curves, level)) << level;
    }
    EXPECT_GT(largest_force_N(felt), 0.3);  // the hand does press
    expect_sound(felt.watch);
}

INSTANTIATE_TEST_SUITE_P(Strands, ScenarioS07, testing::Values(mirrored(), nested()));

// S09: a circle of 256 points and its level of 16 points. The level changes every 50 ms for a
// second while the hand presses at mid-chord.

/// Whether p is outside the circle as rendered, all of which is visible from the origin.
bool is_outside(const CurveSet& curves, double level, Position p) {
    const auto segments = rendered(curves, 0, level);
    return std::any_of(segments.begin(), segments.end(), [&](const Segment& s) {
        return exact::meet({0.0, 0.0}, p, s.a, s.b);
    });
}

TEST(Scenario, S09LevelsChangeUnderAPressedHand) {
    const Scene scene = scene_of({polygon(30.0, 256)});
    constexpr double coarse = 4.0;
    ASSERT_EQ(scene.curves.rendered_count(0, coarse), 16);
    const Direction out{std::cos(pi / 16.0), std::sin(pi / 16.0)};
    const Trajectory press = [=](double t) -> Intention {
        return {along<Position>(out, 35 * mm - 9 * mm * std::min(t / 0.3, 1.0)),
                along<Velocity>(out, t < 0.3 ? -30 * mm : 0.0)};
    };
    const WantedLevel wanted = [](double t) {
        const bool is_fine = t < 0.5 || t > 1.5 || static_cast<int>(t / 0.05) % 2 == 1;
        return is_fine ? 0.0 : coarse;
    };
    const ScenarioRun felt = run(scene, press, 2.0, {}, wanted);
    int inside = 0;
    double worst_jump_N = 0.0;  // beyond what the hand's own motion explains
    const double K = CommonSetUp{}.contact.stiffness_N_per_m;
    for (std::size_t k = 1; k < felt.proxy.size(); ++k) {
        inside += is_outside(scene.curves, felt.level[k], felt.proxy[k]) ? 0 : 1;
        const double by_hand_N = K * norm(felt.hand[k] - felt.hand[k - 1]);
        worst_jump_N = std::max(worst_jump_N, norm(felt.force[k] - felt.force[k - 1]) - by_hand_N);
    }
    EXPECT_EQ(inside, 0);
    EXPECT_LE(worst_jump_N, 0.03);
    EXPECT_LE(felt.watch.switched_J, 1e-3);  // 1 mW over the second
    // The level did change under the hand, and is on its way back.
    const auto pressed = [&](std::size_t k) { return norm(felt.force[k]) > 0.5; };
    double coarsest_pressed = 0.0;
    for (std::size_t k = 0; k < felt.level.size(); ++k) {
        if (pressed(k)) coarsest_pressed = std::max(coarsest_pressed, felt.level[k]);
    }
    EXPECT_GE(coarsest_pressed, 1.0);
    // A wall moves out against a hand at rest as fast as the energy account pays for.
    EXPECT_LT(felt.level.back(), coarse);
    expect_sound(felt.watch);
    RecordProperty("jump_beyond_motion_N", fmt::format("{:.4f}", worst_jump_N));
    RecordProperty("switched_mJ", fmt::format("{:.4f}", 1e3 * felt.watch.switched_J));
    RecordProperty("coarsest_pressed", fmt::format("{:.2f}", coarsest_pressed));
}

}  // namespace
}  // namespace touchline::scenarios
