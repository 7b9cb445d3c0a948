// Handles exactly on a line, at its end or behind a vertex, where a single rounding decides.
#include "haptics/contact/contact_machine.h"
#include "tests/haptics/contact/judge.h"
#include "tests/haptics/scenes.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double pitch_m = 0x1p-8;

/// Leads a machine through handle positions in units of the pitch. Splits edges longer than
/// `spacing_m`.
ContactReport after(const std::vector<Outline>& lines, double radius_m, double friction,
                    const std::vector<Position>& handles, double spacing_m = 1.0) {
    CurveOptions options;
    options.spacing_m = spacing_m;
    const Scene scene = build_scene(scenes::map_of(lines), options, radius_m).value();
    const ContactSettings settings{Mode::wall, 500.0, friction, radius_m, 0.003};
    ContactMachine machine;
    machine.reset(scene, pitch_m * handles[0], 0.0);
    ContactReport report;
    for (std::size_t i = 1; i < handles.size(); ++i) {
        report = machine.step(pitch_m * handles[i], 0.0, settings, {});
    }
    return report;
}

Outline line(Position from, Position to) {
    return scenes::outline({pitch_m * from, pitch_m * to}, false);
}

TEST(ExactPlace, BeyondAnEndOnTheLineItselfIsReached) {
    const Position beyond{1.0, 0.0};
    const ContactReport report =
        after({line({-1, 0}, {0, 0})}, 0.0, 0.0, {{-1, 0}, {0, 0}, beyond});
    EXPECT_EQ(report.state, ContactState::free);
    EXPECT_EQ(report.carried_m, 0.0);
    EXPECT_EQ(report.p_WP, pitch_m * beyond);
}

TEST(ExactPlace, BehindAVertexIsHeldAtRest) {
    const Outline bend = scenes::outline({{-pitch_m, -pitch_m}, {0, -pitch_m}, {pitch_m, 0}}, true);
    const ContactReport report =
        after({bend}, 1e-3, 0.0, {{0.5, -1}, {-1, 0.5}, {-1, 0}, {-1, 0}}, 0.5 * pitch_m);
    EXPECT_EQ(report.carried_m, 0.0);
    EXPECT_EQ(report.state, ContactState::edge);
}

TEST(ExactPlace, AtTheFootOfAnEndKeepsTheParameterOnTheLine) {
    const Outline ring =
        scenes::outline({{-pitch_m, -pitch_m}, {0, -pitch_m}, {-pitch_m, pitch_m}}, true);
    const ContactReport report = after({ring}, 1e-3, 0.0, {{0.5, 0}, {-1.37, -1.37}, {0, -1}});
    EXPECT_EQ(report.state, ContactState::edge);
    EXPECT_GE(report.parameter, 0.0);
}

TEST(ExactPlace, PastAnEndIsReachedByADiscThatKeepsLessThanItsRadius) {
    const std::vector<Outline> crossing{line({-1, -1}, {0, -1}), line({0, -1}, {0, 0})};
    const Position past{0.21, 1.13};
    const ContactReport report =
        after(crossing, 1e-3, 0.3, {{0.5, -0.5}, {0.21, -1.37}, past, past, past, past});
    EXPECT_EQ(report.carried_m, 0.0);
    EXPECT_EQ(report.p_WP, pitch_m * past);
}

TEST(ExactPlace, OnALineIsReachedRoundItsEndThatItShares) {
    const std::vector<Outline> wedge{line({0, -1}, {-1, 0}), line({-1, -1}, {0, -1})};
    const Position under{-0.5, -1};
    const ContactReport report =
        after(wedge, 1e-3, 0.0, {{-0.5, 0}, {1.13, -1.37}, under, under, under, under, under});
    EXPECT_EQ(report.carried_m, 0.0);
    EXPECT_NEAR(report.p_WP.x, pitch_m * under.x, 1e-12);
}

TEST(ExactPlace, RoundTheEndThatTwoOutlinesShareIsReachedByAPoint) {
    const std::vector<Outline> corner{line({0, 0}, {0, -1}), line({0, -1}, {-1, -1})};
    const Position inside{-0.5, 0};
    const ContactReport report =
        after(corner, 0.0, 0.0, {{0.5, 0.5}, {-1.37, -1.37}, inside, inside, inside});
    EXPECT_EQ(report.carried_m, 0.0);
    EXPECT_NEAR(report.p_WP.x, pitch_m * inside.x, 1e-12);
}

TEST(ExactPlace, OnASharpTipIsTouchedOnItsOuterSide) {
    for (const double width : {1e-3, 1e-2, 0.1}) {
        const Outline tip =
            scenes::outline({{pitch_m, 0}, {0, 0}, {pitch_m, pitch_m * width}}, false);
        const Position under{0.5, -0.2};
        const ContactReport report = after({tip}, 0.0, 0.0, {{0, 2}, {0, 0}, under});
        EXPECT_EQ(report.state, ContactState::edge) << width;
        EXPECT_GT(report.p_WP.y, 0.4 * pitch_m * width);
    }
}

/// What a motion is known to be free of says nothing about one that is mere rounding.
TEST(ExactPlace, AMotionBelowRoundingProvesNothing) {
    const Scene scene = build_scene(scenes::map_of({line({-1, 0}, {1, 0})}), {}, 0.0).value();
    const ContactSettings settings;
    ContactMachine machine;
    const Position above{0.0, pitch_m};
    machine.reset(scene, above, 0.0);
    static_cast<void>(machine.step(above + Position{5e-15, 0.0}, 0.0, settings, {}));
    const ContactReport report = machine.step(-above, 0.0, settings, {});
    EXPECT_EQ(report.state, ContactState::edge);
    EXPECT_GE(report.p_WP.y, 0.0);
}

/// It may start anywhere: on a vertex, on an edge, between two with less room than its radius.
TEST(DiscWithoutRoom, CrossesNoLine) {
    const Outline ring = scenes::outline({{-pitch_m, -pitch_m}, {0, -pitch_m}, {0, 0}}, true);
    const Scene scene = build_scene(scenes::map_of({ring}), {}, 1e-3).value();
    const Judge judge(scene.curves, 0.0, pitch_m);
    const ContactSettings settings{Mode::wall, 500.0, 0.0, 1e-3, 0.003};
    for (int start = 0; start < 81; ++start) {
        for (const Position away : {Position{0.5, 1}, {-1, -0.5}, {1, -1.37}}) {
            std::vector<Position> path;
            ContactMachine machine;
            machine.record_path(&path);
            const Position from{0.25 * (start % 9) - 1.5, 0.25 * (start / 9) - 1.5};
            machine.reset(scene, pitch_m * from, 0.0);
            for (const Position handle : {away, Position{-1, -0.5}, {-0.5, -0.5}, -away}) {
                static_cast<void>(machine.step(pitch_m * handle, 0.0, settings, {}));
                ASSERT_TRUE(judge.is_free(path)) << start;
            }
        }
    }
}

TEST(DiscWithoutRoom, HasItsRadiusAgainOnceItIsFree) {
    const Scene scene = build_scene(scenes::map_of({line({-1, 0}, {1, 0})}), {}, 1e-3).value();
    const ContactSettings settings{Mode::wall, 500.0, 0.0, 1e-3, 0.003};
    ContactMachine machine;
    machine.reset(scene, {0.0, 3e-4}, 0.0);
    EXPECT_NEAR(machine.step({0.0, -0.001}, 0.0, settings, {}).p_WP.y, 3e-4, 1e-12);
    static_cast<void>(machine.step({0.0, 0.002}, 0.0, settings, {}));
    EXPECT_NEAR(machine.step({0.0, -0.001}, 0.0, settings, {}).p_WP.y, 1e-3, 1e-12);
}

TEST(DiscAtAJoint, DoesNotSinkHoweverOftenItPasses) {
    const Outline down = line({0, -1}, {-1, 0});
    const Outline flat =
        scenes::outline({{-3.89625e-3, -3.90025e-3}, {3.91625e-3, -3.90025e-3}}, false);
    CurveOptions options;
    options.spacing_m = 1.0;
    const Scene scene = build_scene(scenes::map_of({down, flat}), options, 1e-3).value();
    const ContactSettings settings{Mode::wall, 500.0, 0.0, 1e-3, 0.003};
    ContactMachine machine;
    machine.reset(scene, pitch_m * Position{-1.37, -1.37}, 0.0);
    double least_m = 1.0;
    for (int i = 0; i < 240; ++i) {
        const Position handle = i % 2 == 0 ? Position{0.5, -1} : Position{-1, -1};
        const Position p = machine.step(pitch_m * handle, 0.0, settings, {}).p_WP;
        least_m = std::min(least_m, scene.tree.closest_point(scene.curves, p, 0.0, 1.0).distance_m);
    }
    EXPECT_GE(least_m, 1e-3 - 1e-9);
}

}  // namespace
}  // namespace touchline
