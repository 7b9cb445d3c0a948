// Compares strides over many short edges with what they replace: slides edge by edge.
#include "haptics/contact/contact_machine.h"
#include "haptics/contact/contact_step.h"
#include "tests/haptics/scenes.h"
#include "tests/lab/bench/workload.h"

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double slip_m = 0.010;

struct Agreement {
    int steps = 0;
    int on_edges = 0;
    double worst_m = 0.0;
};

/// Leads the same hand through a machine that strides and one whose proxy is just too thick for it,
/// over the steps that both finish.
Agreement agreement(const Scene& scene, const std::vector<Position>& hand, double level,
                    double friction) {
    ContactSettings thin;
    thin.friction = friction;
    ContactSettings thick = thin;
    thick.radius_m = 1.01 * contact_skin_m;
    ContactMachine strides;
    ContactMachine slides;
    strides.reset(scene, hand[0], level);
    slides.reset(scene, hand[0], level);
    Agreement found;
    for (const Position handle : hand) {
        const ContactReport a = strides.step(handle, level, thin, {});
        const ContactReport b = slides.step(handle, level, thick, {});
        const bool is_cut = a.carried_m > 0.0 || b.carried_m > 0.0;
        if (is_cut || norm(a.p_WP - handle) > slip_m) {
            strides.reset(scene, handle, level);
            slides.reset(scene, handle, level);
            continue;
        }
        ++found.steps;
        found.on_edges += a.state == ContactState::edge ? 1 : 0;
        found.worst_m = std::max(found.worst_m, norm(a.p_WP - b.p_WP));
    }
    return found;
}

TEST(Stride, EndsWhereSlidesLookedAtOneByOneEnd) {
    const auto hand = workload::hand(workload::Kind::radial, 20000);
    for (const std::size_t edges : {512U, 4096U, 16384U}) {
        const auto map = workload::map_of(workload::curve(workload::Kind::radial, edges));
        const Scene scene = build_scene(map, {}, 2.0 * contact_skin_m).value();
        for (const double friction : {0.0, 0.15}) {
            for (const double level : {0.0, 0.4, 1.0, 1.5, 3.0}) {
                const Agreement found = agreement(scene, hand, level, friction);
                EXPECT_GT(found.steps, 19000) << edges << " " << friction << " " << level;
                EXPECT_GT(found.on_edges, 500) << edges << " " << friction << " " << level;
                EXPECT_LE(found.worst_m, 1e-9) << edges << " " << friction << " " << level;
            }
        }
    }
}

/// The end of a piece folds back beside a short piece that is not blended. Half-way through the
/// blend the farther half crosses that piece, though neither end shape does.
TEST(Stride, DoesNotRunThroughABlendedNeighbour) {
    const std::vector<Position> points{{-.00590648, -.0100101},   {-.00512735, -.00845439},
                                       {-.00449416, -.00677188},  {-.0036376, -.00485739},
                                       {-.00296756, -.00315535},  {-.00209118, -.00137104},
                                       {-.000498, -.000786576},   {-.000591539, -1.45114e-06},
                                       {.000388943, 6.01165e-05}, {0, 0},
                                       {.00168, -1e-06},          {.00336, -4e-06},
                                       {.00504, -9e-06}};
    const Scene scene =
        build_scene(scenes::map_of({scenes::outline(points, false)}), {}, 0.0).value();
    ContactMachine machine;
    machine.reset(scene, {3.48329e-05, 9.793e-07}, 0.4);
    static_cast<void>(machine.step({3.477e-05, -9.902e-05}, 0.4, {}, {}));
    const ContactReport report = machine.step({.0025926, -.00020154}, 0.4, {}, {});
    EXPECT_LT(report.p_WP.x, 0.0005);  // held where the neighbour crosses
}

/// A row of 1 mm edges to the right, with given heights.
class Row : public testing::Test {
  protected:
    int passed(const std::vector<double>& heights_m, Position handle, int most = 100) {
        std::vector<Position> points;
        for (std::size_t i = 0; i < heights_m.size(); ++i) {
            points.push_back({1e-3 * static_cast<double>(i), heights_m[i]});
        }
        scene_ = build_scene(scenes::map_of({scenes::outline(points, false)}), {}, 0.0).value();
        RenderedOutlines outlines(scene_, 0.0);
        return vertices_passed(outlines.row(0), scene_.tree, 0, true, {handle, Side::left, 0.0},
                               most);
    }

  private:
    Scene scene_;
};

TEST_F(Row, IsPassedUpToTheHandlesFoot) {
    const std::vector<double> flat(12, 0.0);
    EXPECT_EQ(passed(flat, {0.0055, -0.001}), 5);
    EXPECT_EQ(passed(flat, {0.0005, -0.001}), 0);
    EXPECT_EQ(passed(flat, {0.0055, -0.001}, 3), 3);
    EXPECT_EQ(passed(flat, {0.1, -0.001}), 10);  // the last edge; its end is not a vertex
}

TEST_F(Row, IsLeftWhereTheHandleDoesNotPress) {
    const std::vector<double> flat(12, 0.0);
    EXPECT_EQ(passed(flat, {0.0055, 0.001}), 0);
    EXPECT_EQ(passed(flat, {0.0055, 0.0}), 0);
}

TEST_F(Row, IsStoodStillInWhereAWallHoldsTheProxy) {
    // A slope of 30 degrees from 3 mm on: the handle below does not pull the proxy up.
    EXPECT_EQ(passed({0, 0, 0, 0, 0.577e-3, 1.154e-3}, {0.0045, -0.003}), 2);
    EXPECT_EQ(passed({0, 0, 0, 0, 0.577e-3, 1.154e-3}, {0.0045, -0.001}), 4);  // in halves
}

}  // namespace
}  // namespace touchline
