// N1 to N4 and the cone at a vertex: Coulomb friction of the line, kept as the stretch between
// proxy and hand. The reference is the same cone in one dimension.
#include "tests/haptics/contact/scenarios/runner.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace touchline::scenarios {
namespace {

CommonSetUp with_friction(double friction, double radius_m = 0.0) {
    CommonSetUp set_up;
    set_up.contact.friction = friction;
    set_up.contact.radius_m = radius_m;
    set_up.tip.coulomb_N = 0.0;
    return set_up;
}

TEST(Friction, N1AHeldMassDoesNotCreepUnderVibration) {
    const Scene scene = scene_of({flat_line()});
    WatchedMachine contact(scene, with_friction(0.3), {0.0, 1e-6});
    // 1 N presses, so the line can hold 0.3 N; 0.15 N pulls along it, plus 0.09 N at 10 Hz.
    constexpr double h_s = 1e-4;
    TipDynamics mass({0.1, 1.0, 0.0}, no_hand, {0.0, -1 * mm});
    Position after_1_s;
    for (int k = 0; k < 600000; ++k) {
        const Force held = contact.step(mass.tip().position).force;
        mass.step(held + Force{0.15 + 0.09 * std::sin(2.0 * pi * 10.0 * k * h_s), -1.0}, {}, h_s);
        if (k == 9999) after_1_s = mass.tip().position;
    }
    const double drift_m = std::abs(mass.tip().position.x - after_1_s.x) * 60.0 / 59.0;
    EXPECT_LT(drift_m, 1e-6);
    EXPECT_GT(std::abs(mass.tip().position.x - contact.machine().proxy().centre.x), 0.05 * mm);
    expect_sound(contact.watch());
    RecordProperty("drift_um_per_min", fmt::format("{:.3g}", 1e6 * drift_m));
}

TEST(Friction, N2TheHoldingForceDoesNotRelaxUnderTremor) {
    const Scene scene = scene_of({flat_line()});
    WatchedMachine contact(scene, with_friction(0.3), {0.0, 1e-6});
    // At 1 mm depth the line holds a stretch of 0.3 mm; the hand goes to 0.8 of it.
    const auto force_at = [&](double x_m) { return -contact.step({x_m, -1 * mm}).force.x; };
    constexpr double held_m = 0.24 * mm;
    for (int k = 0; k < 300; ++k) static_cast<void>(force_at(held_m * k / 300.0));
    const double before_N = force_at(held_m);
    for (int k = 0; k < 10000; ++k) {
        static_cast<void>(force_at(held_m + 0.02 * mm * std::sin(2.0 * pi * 8.0 * k * tick_s)));
    }
    const double after_N = force_at(held_m);
    EXPECT_NEAR(before_N, 0.24, 1e-6);
    EXPECT_NEAR(after_N, before_N, 0.01 * before_N);
    expect_sound(contact.watch());
    RecordProperty("lost_percent", fmt::format("{:.3g}", 100.0 * (1.0 - after_N / before_N)));
}

class FrictionN3 : public testing::TestWithParam<double> {};

TEST_P(FrictionN3, OneCoefficientGivesNoStickSlip) {
    const double v = GetParam();
    // The hand aims so deep that its 300 N/m press with 1 N: 1 mm of wall and 3.3 mm of hand.
    const double deep_m = 1 * mm + 1.0 / normal_hand.stiffness_N_per_m;
    const double down_m_per_s = (1 * mm + deep_m) / 0.5;
    const Trajectory pull = [=](double t) -> Intention {
        if (t < 0.5) return {{0.0, 1 * mm - down_m_per_s * t}, {0.0, -down_m_per_s}};
        return {{v * (t - 0.5), -deep_m}, {v, 0.0}};
    };
    const Scene scene = scene_of({{{{-50.0, 0.0}, {350.0, 0.0}}}});
    const ScenarioRun felt = run(scene, pull, 6.5, with_friction(0.3));
    std::vector<double> lag_m;
    std::vector<double> drag_N;
    for (std::size_t k = felt.hand.size() / 2; k < felt.hand.size(); ++k) {
        lag_m.push_back(felt.hand[k].x - v * tick_s * static_cast<double>(k));
        drag_N.push_back(-felt.force[k].x);
    }
    const auto extent = [](const std::vector<double>& values) {
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        return *high - *low;
    };
    // With mu_s = 2 mu_d the hand would hop by 1.45 mm.
    EXPECT_LT(extent(lag_m), 1e-6);
    EXPECT_LT(extent(drag_N), 1e-3);
    EXPECT_NEAR(drag_N.back(), 0.3, 1e-3);
    expect_sound(felt.watch);
    RecordProperty("hand_pp_mm", fmt::format("{:.3g}", extent(lag_m) / mm));
    RecordProperty("drag_pp_N", fmt::format("{:.3g}", extent(drag_N)));
}

INSTANTIATE_TEST_SUITE_P(Speeds, FrictionN3, testing::Values(0.002, 0.010, 0.050));

struct Loop {
    double friction, work_J;  // the reference's
};

class FrictionN4 : public testing::TestWithParam<Loop> {};

TEST_P(FrictionN4, AClosedLoopCostsTheFrictionOfItsWay) {
    const double mu = GetParam().friction;
    const Scene scene = scene_of({flat_line()});
    const std::vector<Position> corners{
        {0.0, 2 * mm}, {0.0, -1.5 * mm}, {20 * mm, -1.5 * mm}, {20 * mm, 2 * mm}, {0.0, 2 * mm}};
    WatchedMachine contact(scene, with_friction(mu), corners.front());
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const Position way = corners[i] - corners[i - 1];
        const int steps = static_cast<int>(norm(way) / (50 * mm * tick_s));
        for (int k = 0; k < steps; ++k) {
            static_cast<void>(contact.step(corners[i - 1] + static_cast<double>(k) / steps * way));
        }
    }
    static_cast<void>(contact.step(corners.back()));
    const double work_J = contact.watch().work_J;
    constexpr double pressed_N = 1.5;
    constexpr double slid_m = 0.02;
    if (mu > 0.0) {
        EXPECT_TRUE(is_within(work_J, -mu * pressed_N * slid_m, 0.05));
    }
    EXPECT_TRUE(is_within(work_J, GetParam().work_J, 0.03));
    EXPECT_TRUE(is_within(contact.watch().allowed_J, 5.75e-4, 0.10));
    expect_sound(contact.watch());
}

INSTANTIATE_TEST_SUITE_P(Coefficients, FrictionN4,
                         testing::Values(Loop{0.0, 7.5e-5}, Loop{0.1, -2.91e-3},
                                         Loop{0.3, -8.81e-3}, Loop{0.6, -17.5e-3}));

/// Normal and tangential part of a contact force.
struct Parts {
    Force normal, tangential;
};

Parts parts(Force force, Direction n) {
    const auto normal = along<Force>(n, dot(force, n));
    return {normal, force - normal};
}

/// Drags a hand along a way behind a line, past the line's vertices. At every step the friction is
/// inside the cone and changes by no more than the change of the normal force and the hand's own
/// motion explain.
void expect_friction_survives(const Scene& scene, double radius_m, Position start,
                              const std::vector<Position>& way) {
    constexpr double mu = 0.3;
    const CommonSetUp set_up = with_friction(mu, radius_m);
    WatchedMachine contact(scene, set_up, start);
    ContactReport report = contact.step(way.front());
    ASSERT_NE(report.state, ContactState::free);
    int changes = 0;
    for (std::size_t k = 1; k < way.size(); ++k) {
        const Contact before = contact.machine().proxy().contacts[0];
        const Parts a = parts(report.force, before.normal);
        report = contact.step(way[k]);
        ASSERT_NE(report.state, ContactState::free) << k;
        const Contact now = contact.machine().proxy().contacts[0];
        const Parts b = parts(report.force, now.normal);
        const double by_hand_N =
            set_up.contact.stiffness_N_per_m * norm(way[k] - way[k - 1]) * (1.0 + mu);
        ASSERT_LE(norm(b.tangential), mu * norm(b.normal) + 1e-9) << k;
        ASSERT_LE(norm(b.tangential - a.tangential),
                  mu * norm(b.normal - a.normal) + by_hand_N + 1e-9)
            << k;
        if (before.segment != now.segment) ++changes;
    }
    EXPECT_GT(changes, 8);
    expect_sound(contact.watch());
}

/// Goes there and back, 50 um a step.
std::vector<Position> there_and_back(const std::function<Position(double s_m)>& at,
                                     double length_m) {
    constexpr double step_m = 5e-5;
    const int steps = static_cast<int>(length_m / step_m);
    std::vector<Position> way;
    for (int k = -steps; k <= steps; ++k) way.push_back(at((steps - std::abs(k)) * step_m));
    return way;
}

TEST(Friction, SurvivesAChangeOfEdgeOnAStraightLine) {
    // Two outlines end to end, in edges of 0.5 mm.
    CurveOptions options;
    options.spacing_m = 0.5 * mm;
    const Polyline left{{{-50.0, 0.0}, {3.0, 0.0}}};
    const Polyline right{{{3.0, 0.0}, {50.0, 0.0}}};
    for (const double radius_m : {0.0, 5e-5}) {
        SCOPED_TRACE(radius_m);
        const Scene scene = scene_of({left, right}, radius_m, options);
        expect_friction_survives(scene, radius_m, {0.0, 1 * mm},
                                 there_and_back(
                                     [](double s_m) {
                                         return Position{s_m, -1 * mm};
                                     },
                                     8 * mm));
    }
}

TEST(Friction, SurvivesAConvexVertex) {
    for (const double radius_m : {0.0, 5e-5, 1e-3}) {
        SCOPED_TRACE(radius_m);
        const Scene scene = scene_of({polygon(30.0, 16)}, radius_m);
        const double hand_radius_m = 28.5 * mm;
        expect_friction_survives(
            scene, radius_m, {32 * mm, 0.0},
            there_and_back(
                [=](double s_m) {
                    const double angle = s_m / hand_radius_m;
                    return hand_radius_m * Position{std::cos(angle), std::sin(angle)};
                },
                60 * mm));
    }
}

}  // namespace
}  // namespace touchline::scenarios
