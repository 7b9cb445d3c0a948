#include "haptics/contact/contact_machine.h"
#include "tests/haptics/contact/hold_rig.h"
#include "tests/haptics/contact/judge.h"
#include "tests/haptics/scenes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using scenes::map_of;
using scenes::outline;

/// A hand that wanders over the scene: presses, sweeps and jumps.
class Wanderer {
  public:
    explicit Wanderer(unsigned seed) : random_(seed) {}

    Position next() {
        if (unit() < 0.02) heading_ = 2.0 * std::numbers::pi * unit();
        if (unit() < 0.01) speed_ = std::pow(10.0, -5.0 + 2.5 * unit());
        heading_ += 0.2 * (unit() - 0.5);
        at_ += speed_ * Position{std::cos(heading_), std::sin(heading_)};
        at_ = {std::clamp(at_.x, -0.05, 0.05), std::clamp(at_.y, -0.05, 0.05)};
        if (unit() < 0.002) at_ = {0.1 * (unit() - 0.5), 0.1 * (unit() - 0.5)};
        return at_;
    }

  private:
    double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }

    std::mt19937 random_;
    Position at_{0.049, 0.049};
    double heading_ = 4.0;
    double speed_ = 3e-4;
};

bool are_allowed(const ContactReport& report) {
    for (int i = 1; i < report.transitions.size(); ++i) {
        if (std::abs(static_cast<int>(report.transitions[i]) -
                     static_cast<int>(report.transitions[i - 1])) != 1) {
            return false;
        }
    }
    return true;
}

struct Case {
    double level;
    double radius_m;
    double friction;
};

class Contact : public testing::TestWithParam<Case> {};

TEST_P(Contact, NeverCrossesALineNorMovesAwayFromTheHandOnAnyScene) {
    const auto [level, radius, friction] = GetParam();
    ContactSettings settings;
    settings.radius_m = radius;
    settings.friction = friction;
    int touching = 0;
    for (unsigned seed = 0; seed < 12; ++seed) {
        const Scene scene = scene_of(scenes::random_map(seed, 4), radius);
        const Judge judge(scene.curves, level, 2e-3);
        Wanderer hand(seed);
        std::vector<Position> path;
        ContactMachine machine;
        machine.record_path(&path);
        machine.reset(scene, hand.next(), level);
        Position before = machine.proxy().centre;
        for (int i = 0; i < 1500; ++i) {
            const Position handle = hand.next();
            const ContactReport report = machine.step(handle, level, settings, {});
            ASSERT_TRUE(judge.is_free(path)) << seed << " " << i;
            ASSERT_LE(norm(handle - report.p_WP), norm(handle - before) + 1e-12)
                << seed << " " << i;
            ASSERT_EQ(report.force, along<Force>(report.p_WP - handle, 500.0));
            ASSERT_TRUE(are_allowed(report)) << seed << " " << i;
            ASSERT_EQ(report.state == ContactState::free, report.outline < 0);
            if (i % 20 == 0 && report.carried_m == 0.0 && radius == 0.0 && friction == 0.0) {
                ASSERT_LE(judge.possible_gain_m(report.p_WP, handle), 1e-9) << seed << " " << i;
            }
            touching += report.state != ContactState::free ? 1 : 0;
            before = report.p_WP;
        }
    }
    EXPECT_GT(touching, 1000);
}

INSTANTIATE_TEST_SUITE_P(LevelsRadiiAndFriction, Contact,
                         testing::Values(Case{0.0, 0.0, 0.0}, Case{1.0, 0.0, 0.0},
                                         Case{0.5, 0.0, 0.0}, Case{2.7, 0.0, 0.0},
                                         Case{0.0, 5e-5, 0.0}, Case{0.0, 1e-3, 0.0},
                                         Case{1.5, 2.8e-3, 0.0}, Case{0.0, 0.0, 0.3},
                                         Case{0.0, 1.4e-3, 0.15}));

TEST(ContactMachine, KeepsItsRadiusFromEveryLine) {
    ContactSettings settings;
    settings.radius_m = 1e-3;
    for (unsigned seed = 0; seed < 10; ++seed) {
        const Scene scene = scene_of(scenes::random_map(seed, 2), settings.radius_m);
        const Judge judge(scene.curves, 0.0, 2e-3);
        Wanderer hand(seed);
        ContactMachine machine;
        Position start = hand.next();
        machine.reset(scene, start, 0.0);
        if (judge.distance_m(start, 2e-3) < settings.radius_m) continue;
        for (int i = 0; i < 2000; ++i) {
            const ContactReport report = machine.step(hand.next(), 0.0, settings, {});
            // Rounding a vertex in chords of 15 degrees may cost 1 % of the radius at another line.
            ASSERT_GE(judge.distance_m(report.p_WP, 2e-3), 0.98 * settings.radius_m)
                << seed << " " << i;
        }
    }
}

/// Triangles with a sharp tip, both ways round, and a spike that goes out and back.
std::vector<Outline> sharp_outlines() {
    std::vector<Outline> made;
    for (const double half_angle : {0.02, 0.1, 0.35, 0.6}) {
        const Position out{0.03 * std::cos(half_angle), 0.03 * std::sin(half_angle)};
        Outline tip = outline({{0, 0}, {out.x, -out.y}, {out.x, out.y}}, true);
        made.push_back(tip);
        std::reverse(tip.points.begin(), tip.points.end());
        made.push_back(tip);
    }
    made.push_back(outline({{-0.02, 0}, {0.02, 0}, {-0.01, 0}}, false));
    return made;
}

TEST(ContactMachine, SharpTipsAreRoundedOnTheirOuterSide) {
    for (const double radius : {5e-5, 1e-3, 3e-3}) {
        ContactSettings settings;
        settings.radius_m = radius;
        const auto sharp_ones = sharp_outlines();
        for (std::size_t k = 0; k < sharp_ones.size(); ++k) {
            SCOPED_TRACE(k);
            const Outline& sharp = sharp_ones[k];
            const Scene scene = scene_of(map_of({sharp}), radius);
            const Judge judge(scene.curves, 0.0, 2e-3);
            Wanderer hand(17);
            std::vector<Position> path;
            ContactMachine machine;
            machine.record_path(&path);
            machine.reset(scene, {-0.03, 0.02}, 0.0);
            Position before = machine.proxy().centre;
            for (int i = 0; i < 4000; ++i) {
                const Position handle = 0.6 * hand.next();
                const ContactReport report = machine.step(handle, 0.0, settings, {});
                ASSERT_TRUE(judge.is_free(path)) << radius << " " << i;
                ASSERT_LE(norm(handle - report.p_WP), norm(handle - before) + 1e-12) << i;
                ASSERT_GE(judge.distance_m(report.p_WP, 4e-3), 0.98 * radius) << radius << " " << i;
                before = report.p_WP;
            }
        }
    }
}

TEST(ContactMachine, TheFirstHandleOnALineStartsOnItsLeft) {
    const Scene scene = scene_of(map_of({outline({{-0.01, 0}, {0.01, 0}}, false)}));
    ContactMachine machine;
    machine.reset(scene, {0.001, 0.0}, 0.0);
    EXPECT_EQ(machine.proxy().state, ContactState::free);
    EXPECT_LE(norm(machine.proxy().centre - Position{0.001, contact_skin_m}), 1e-18);
    const ContactReport right = machine.step({0.001, -0.002}, 0.0, {}, {});
    EXPECT_EQ(right.state, ContactState::edge);
    EXPECT_EQ(right.side, Side::left);
    EXPECT_NEAR(right.force.y, 1.0, 1e-6);
}

TEST(ContactMachine, AFlatWallGivesTheNormalForceAndLetsTheTangentSlide) {
    const Scene scene = scene_of(map_of({outline({{-0.05, 0}, {0.05, 0}}, false)}));
    ContactMachine machine;
    machine.reset(scene, {0.0, 0.01}, 0.0);
    const ContactReport first = machine.step({0.0, -0.003}, 0.0, {}, {});
    EXPECT_EQ(first.transitions.size(), 2);
    EXPECT_NEAR(first.force.y, 1.5, 1e-7);
    const ContactReport slid = machine.step({0.02, -0.003}, 0.0, {}, {});
    EXPECT_NEAR(slid.p_WP.x, 0.02, 1e-12);
    EXPECT_NEAR(slid.force.x, 0.0, 1e-9);
    const ContactReport off = machine.step({0.02, 0.001}, 0.0, {}, {});
    EXPECT_EQ(off.state, ContactState::free);
    EXPECT_EQ(off.force, Force{});
}

TEST(ContactMachine, AConcaveCornerHoldsWithTwoContactsAndLetsGo) {
    const Scene scene = scene_of(map_of({outline({{-0.02, 0.02}, {0, 0}, {0.02, 0.02}}, false)}));
    ContactMachine machine;
    machine.reset(scene, {0.0, 0.01}, 0.0);
    const ContactReport held = machine.step({0.0005, -0.004}, 0.0, {}, {});
    EXPECT_EQ(held.state, ContactState::vertex);
    EXPECT_LE(norm(held.p_WP), 2.0 * contact_skin_m);
    EXPECT_EQ(machine.proxy().contact_count, 2);
    const ContactReport slid = machine.step({0.01, -0.004}, 0.0, {}, {});
    EXPECT_EQ(slid.state, ContactState::edge);
    EXPECT_NEAR(slid.p_WP.x, 0.003, 1e-9);
    EXPECT_EQ(machine.step({0.0, 0.01}, 0.0, {}, {}).state, ContactState::free);
}

TEST(ContactMachine, ALineSEndIsRoundedAndCanBePassed) {
    ContactSettings settings;
    settings.radius_m = 2e-3;
    const Scene scene = scene_of(map_of({outline({{-0.05, 0}, {0, 0}}, false)}), settings.radius_m);
    ContactMachine machine;
    machine.reset(scene, {-0.01, 0.01}, 0.0);
    ContactReport report = machine.step({-0.01, 0.001}, 0.0, settings, {});
    EXPECT_NEAR(report.p_WP.y, 2e-3, 1e-12);
    report = machine.step({0.001, 0.0005}, 0.0, settings, {});
    EXPECT_EQ(report.state, ContactState::vertex);
    EXPECT_NEAR(norm(report.p_WP), 2e-3, 1e-9);
    EXPECT_NEAR(cross(report.p_WP, Position{0.001, 0.0005}), 0.0, 1e-12);
    report = machine.step({-0.002, -0.0015}, 0.0, settings, {});
    EXPECT_EQ(report.state, ContactState::edge);
    EXPECT_EQ(report.side, Side::right);
    EXPECT_NEAR(report.p_WP.y, -2e-3, 1e-12);
}

TEST(ContactMachine, FrictionHoldsInsideTheConeAndDragsAtItsEdge) {
    const Scene scene = scene_of(map_of({outline({{-0.05, 0}, {0.05, 0}}, false)}));
    ContactSettings settings;
    settings.friction = 0.3;
    ContactMachine machine;
    machine.reset(scene, {0.0, 0.01}, 0.0);
    static_cast<void>(machine.step({0.0, -0.002}, 0.0, settings, {}));
    EXPECT_EQ(machine.step({0.0005, -0.002}, 0.0, settings, {}).p_WP.x, 0.0);
    const ContactReport slid = machine.step({0.003, -0.002}, 0.0, settings, {});
    EXPECT_NEAR(slid.p_WP.x, 0.003 - 0.3 * 0.002, 1e-9);
    EXPECT_NEAR(-slid.force.x, 0.3 * slid.force.y, 1e-6);
}

TEST(ContactMachine, AHandleThatIsNoPlaceGivesNoForceAndChangesNothing) {
    const Scene scene = scene_of(map_of({outline({{-0.05, 0}, {0.05, 0}}, false)}));
    ContactMachine machine;
    machine.reset(scene, {0.0, 0.01}, 0.0);
    static_cast<void>(machine.step({0.0, -0.002}, 0.0, {}, {}));
    const Position before = machine.proxy().centre;
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        const ContactReport report = machine.step({bad, 0.0}, 0.0, {}, {});
        EXPECT_EQ(report.force, Force{});
        EXPECT_EQ(machine.proxy().centre, before);
    }
    EXPECT_GT(machine.step({0.0, -0.002}, 0.0, {}, {}).force.y, 0.9);
    machine.reset(scene, {std::nan(""), 0.0}, std::nan(""));
    EXPECT_EQ(machine.step({0.0, 0.01}, 0.0, {}, {}).force, Force{});
    EXPECT_GT(machine.step({0.0, -0.002}, 0.0, {}, {}).force.y, 0.9);
}

TEST(ContactMachine, WithoutBudgetTheMotionIsCarriedAndNothingIsCrossed) {
    const Scene scene = scene_of(map_of({scenes::circle(0.03, 256)}));
    ContactMachine machine;
    machine.reset(scene, {0.0, 0.0}, 0.0);
    ContactReport report = machine.step({0.04, 0.0}, 0.0, {}, {.boxes = 1});
    EXPECT_GT(report.carried_m, 0.0);
    EXPECT_LT(report.clear, 1.0);
    EXPECT_LE(report.boxes, 1);
    report = machine.step({0.04, 0.0}, 0.0, {}, {});
    EXPECT_EQ(report.carried_m, 0.0);
    EXPECT_NEAR(report.p_WP.x, 0.03, 1e-5);
}

TEST(ContactMachine, DoubledAndCrossingLinesNeverHoldTheProxyWhereItCouldGoOn) {
    // Every edge twice, once reversed, and a second polygon that shares its corners.
    const Outline ring = scenes::square(0.04, 1);
    Outline reversed = ring;
    std::reverse(reversed.points.begin(), reversed.points.end());
    ContactSettings settings;
    settings.radius_m = 5e-5;
    const Scene doubled = scene_of(map_of({ring, reversed, ring}), settings.radius_m);
    const Scene single = scene_of(map_of({ring}), settings.radius_m);
    ContactMachine a;
    ContactMachine b;
    a.reset(doubled, {0.03, 0.0}, 0.0);
    b.reset(single, {0.03, 0.0}, 0.0);
    for (int i = 0; i < 4000; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 2000.0;
        const Position handle = 0.019 * Position{std::cos(angle), std::sin(angle)};
        const Force twice = a.step(handle, 0.0, settings, {}).force;
        const Force once = b.step(handle, 0.0, settings, {}).force;
        ASSERT_LE(norm(twice - once), 1e-9) << i;
    }
}

TEST(ContactMachine, AHandThatCreepsIsNotLetThrough) {
    const Scene scene = scene_of(map_of({outline({{-0.01, 0.0}, {0.01, 0.0}}, false)}));
    ContactMachine machine;
    machine.reset(scene, {0.0, 2e-11}, 0.0);
    Position handle{0.0, 2e-11};
    for (int i = 0; i < 5000; ++i) {
        handle.y -= 0.9e-13;
        const ContactReport report = machine.step(handle, 0.0, {}, {});
        ASSERT_GT(report.p_WP.y, 0.0) << i;
    }
}

TEST(ContactMachine, SettingsThatAreNotNumbersMoveNothing) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const Scene scene = scene_of(map_of({outline({{-0.01, 0.0}, {0.01, 0.0}}, false)}));
    for (double ContactSettings::*const setting :
         {&ContactSettings::friction, &ContactSettings::radius_m,
          &ContactSettings::stiffness_N_per_m}) {
        ContactMachine machine;
        machine.reset(scene, {0.0, 0.001}, 0.0);
        ContactSettings settings;
        settings.*setting = nan;
        const ContactReport report = machine.step({0.0, -0.001}, 0.0, settings, {});
        EXPECT_EQ(report.force, Force{});
        EXPECT_GT(machine.step({0.001, -0.001}, 0.0, {}, {}).p_WP.y, 0.0);
    }
}

}  // namespace
}  // namespace touchline
