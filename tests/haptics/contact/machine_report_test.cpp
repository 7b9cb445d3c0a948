// What a contact machine reports beside the force, and that a reset machine is as good as new.
#include "haptics/contact/contact_machine.h"
#include "tests/haptics/contact/hold_rig.h"
#include "tests/haptics/scenes.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using scenes::map_of;
using scenes::outline;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

ContactSettings giving_way(Mode mode) {
    ContactSettings settings = settings_of(mode);
    settings.radius_m = 1e-3;
    settings.pop_through_N = 1.5;
    settings.pop_through_s = 0.03;
    return settings;
}

/// A ring with a wavy line across it that ends inside.
Scene busy_scene() {
    std::vector<Position> wave;
    for (int i = 0; i <= 100; ++i)
        wave.push_back({-0.04 + 5e-4 * i, 2e-3 * std::sin(0.3 * i) + 1e-4 * (i % 2)});
    TactileMap map = map_of({scenes::circle(0.03, 300), outline(wave, false)});
    return build_scene(map, {}, 1e-3).value();
}

/// Presses, slides off the line's end, comes back and is pushed through while the level changes to
/// and fro. Returns every report.
std::vector<ContactReport> session(ContactMachine& machine, Mode mode) {
    std::vector<ContactReport> all;
    for (int i = 0; i < 400; ++i) {
        const double along = -0.02 + 1e-4 * i;
        const Position hand{along, 4e-3 * std::cos(2.0 * std::numbers::pi * i / 150.0)};
        all.push_back(machine.step(hand, i / 20 % 2 == 0 ? 0.0 : 2.5, giving_way(mode), {}));
    }
    return all;
}

void expect_equal(const ContactReport& a, const ContactReport& b) {
    ASSERT_EQ(a.force, b.force);
    ASSERT_EQ(a.stored_J, b.stored_J);
    ASSERT_EQ(a.p_WP, b.p_WP);
    ASSERT_EQ(a.state, b.state);
    ASSERT_EQ(a.level, b.level);
    ASSERT_EQ(a.outline, b.outline);
    ASSERT_EQ(a.is_at_end, b.is_at_end);
    ASSERT_EQ(a.has_popped, b.has_popped);
    ASSERT_EQ(a.boxes, b.boxes);
}

/// It may have been stopped anywhere: pressed, in a fade, half through a wall, beside an end, at a
/// level.
TEST(ContactReset, AMachineThatIsResetIsAsNew) {
    const Scene scene = busy_scene();
    const Position start{-0.02, 4e-3};
    for (const Mode before : all_modes) {
        for (const Mode after : all_modes) {
            ContactMachine fresh;
            fresh.reset(scene, start, 0.0);
            const auto expected = session(fresh, after);
            for (const int stop : {1, 35, 52, 80, 110, 200, 290, 330, 399}) {
                ContactMachine used;
                used.reset(scene, start, 0.0);
                for (int i = 0; i < stop; ++i) {
                    const Position hand{-0.02 + 1e-4 * i, 4e-3 - 1e-4 * (i % 80)};
                    (void)used.step(hand, i / 15 % 2 == 0 ? 0.0 : 2.5, giving_way(before), {});
                }
                if (stop % 2 == 0) (void)used.step({0.0, 0.0}, 1.0, giving_way(after), {});
                used.reset(scene, start, 0.0);
                const auto found = session(used, after);
                for (std::size_t i = 0; i < found.size(); ++i) {
                    expect_equal(found[i], expected[i]);
                    if (testing::Test::HasFatalFailure())
                        FAIL() << static_cast<int>(before) << static_cast<int>(after) << ' ' << stop
                               << ' ' << i;
                }
            }
        }
    }
}

TEST(ContactReport, AWallStoresWhatItsSpringDoes) {
    const Scene scene = scene_of(map_of({outline({{-0.05, 0.0}, {0.05, 0.0}}, false)}));
    ContactMachine machine;
    machine.reset(scene, {0.0, 0.001}, 0.0);
    EXPECT_EQ(machine.step({0.0, 0.0005}, 0.0, {}, {}).stored_J, 0.0);
    EXPECT_NEAR(machine.step({0.0, -0.002}, 0.0, {}, {}).stored_J, 0.5 * 500.0 * 4e-6, 1e-9);
}

TEST(ContactReport, AGrooveStoresWhatItsLawSays) {
    const Scene scene = scene_of(map_of({outline({{-0.05, 0.0}, {0.05, 0.0}}, false)}));
    for (const Mode mode : hold_modes) {
        ContactMachine machine;
        machine.reset(scene, {0.0, 0.001}, 0.0);
        const ContactReport report = machine.step({0.0, 0.001}, 0.0, settings_of(mode), {});
        EXPECT_NEAR(report.stored_J, CaptureLaw(settings_of(mode)).energy_J(0.001), 1e-12);
        EXPECT_EQ(report.clear, 1.0);
        EXPECT_GT(report.boxes, 0);
        EXPECT_EQ(report.transitions.size(), 2);
        EXPECT_EQ(machine.proxy().contact_count, 1);
    }
}

/// A step without a handle changes nothing and reports the proxy as it was.
TEST(ContactReport, WithoutAHandleTheProxyIsToldWhereItIs) {
    EXPECT_EQ(ContactReport{}.stored_J, 0.0);
    const Scene scene = scene_of(map_of({scenes::circle(0.03, 256)}));
    ContactMachine machine;
    machine.reset(scene, {0.0, 0.0}, 2.0);
    (void)machine.step({0.01, 0.0}, 2.0, {}, {});
    const ContactReport report = machine.step({nan, 0.0}, 2.0, {}, {});
    EXPECT_EQ(report.p_WP, (Position{0.01, 0.0}));
    EXPECT_EQ(report.level, 2.0);
    EXPECT_EQ(report.state, ContactState::free);
}

/// A step without time moves nothing either.
TEST(ContactReport, NoTimeMovesNothing) {
    const Scene scene = scene_of(map_of({scenes::circle(0.03, 256)}));
    ContactMachine machine;
    machine.reset(scene, {0.0, 0.0}, 0.0);
    EXPECT_EQ(machine.step({0.01, 0.0}, 0.0, {}, {}, 0.0).p_WP, Position{});
    EXPECT_EQ(machine.step({0.01, 0.0}, 0.0, {}, {}, -1.0).p_WP, Position{});
}

TEST(ContactReport, LevelsBeyondTheFinestAndTheCoarsestAreThose) {
    const Scene scene = scene_of(map_of({scenes::circle(0.03, 256)}));
    const double coarsest = scene.curves.coarsest();
    ContactMachine machine;
    machine.reset(scene, {0.0, 0.0}, -1.0);
    EXPECT_EQ(machine.rendered_level(), 0.0);
    EXPECT_EQ(machine.step({0.0, 0.0}, -1.0, {}, {}).level, 0.0);
    EXPECT_EQ(machine.step({0.0, 0.0}, 1e9, {}, {}).level, coarsest);
    machine.reset(scene, {0.0, 0.0}, nan);
    EXPECT_EQ(machine.rendered_level(), 0.0);
}

/// All queries of a step share one budget: widening, a push through, a change of level, the way.
TEST(ContactReport, AStepOpensNoMoreBoxesThanItMay) {
    const Scene scene = busy_scene();
    for (const Mode mode : all_modes) {
        for (const int most : {0, 1, 3, 7, 20, 60}) {
            ContactMachine machine;
            machine.reset(scene, {-0.02, 4e-3}, 0.0);
            int opened = 0;
            for (int i = 0; i < 400; ++i) {
                ContactSettings settings = giving_way(mode);
                settings.radius_m = i % 3 == 0 ? 1e-3 : 5e-4;
                const Position hand{-0.02 + 1e-4 * i,
                                    4e-3 * std::cos(2.0 * std::numbers::pi * i / 150.0)};
                const double level = 0.5 * (i % 6);
                const ContactReport report = machine.step(hand, level, settings, {.boxes = most});
                ASSERT_GE(report.boxes, 0) << i;
                ASSERT_LE(report.boxes, most) << i;
                opened += report.boxes;
            }
            EXPECT_EQ(opened > 0, most > 0);
        }
    }
}

/// A deadline long past leaves the proxy where it is, held by what it is behind; one that never
/// comes has no effect.
TEST(ContactReport, AStepThatIsLateMovesNothing) {
    const Scene scene = busy_scene();
    constexpr std::int64_t never_ns = std::numeric_limits<std::int64_t>::max();
    const Position from{-0.02, 4e-3};
    const Position to{-0.02, -6e-3};
    for (const std::int64_t deadline_ns : {std::int64_t{1}, never_ns}) {
        ContactMachine machine;
        ContactMachine in_time;
        ContactSettings settings;
        machine.reset(scene, from, 0.0);
        in_time.reset(scene, from, 0.0);
        for (int i = 0; i < 3; ++i) {
            const Budget budget{.deadline_ns = deadline_ns};
            const ContactReport report = machine.step(to, 0.0, settings, budget);
            const ContactReport wanted = in_time.step(to, 0.0, settings, {});
            EXPECT_EQ(report.p_WP, deadline_ns == never_ns ? wanted.p_WP : from);
            EXPECT_EQ(report.carried_m,
                      deadline_ns == never_ns ? wanted.carried_m : norm(to - from));
        }
    }
}

/// A proxy beside the corner where it left the line is beyond no end: the line goes on there.
TEST(ContactReport, ACornerIsNoEnd) {
    const Scene scene =
        scene_of(map_of({outline({{-0.01, 0.0}, {0.0, 0.0}, {0.0, -0.01}}, false)}));
    ContactMachine machine;
    machine.reset(scene, {1e-3, -1e-3}, 0.0);
    const ContactSettings settings;
    ContactReport report = machine.step({-5e-4, -1e-3}, 0.0, settings, {});
    EXPECT_EQ(report.piece, 1);
    report = machine.step({5e-4, 3e-4}, 0.0, settings, {});
    EXPECT_EQ(report.state, ContactState::free);
    EXPECT_FALSE(report.is_at_end);
}

/// What was free for a point may not be free for a disc.
TEST(ContactReport, ADiscThatHasGrownLooksAnew) {
    constexpr double radius_m = 1e-3;
    const Scene scene =
        build_scene(map_of({outline({{-0.01, 0.0}, {0.01, 0.0}}, false)}), {}, radius_m).value();
    ContactMachine machine;
    ContactSettings settings;
    machine.reset(scene, {0.0, 0.010}, 0.0);
    (void)machine.step({0.0, 0.009}, 0.0, settings, {});
    settings.radius_m = radius_m;
    (void)machine.step({0.0, 0.008}, 0.0, settings, {});
    const ContactReport report = machine.step({0.0, 0.3e-3}, 0.0, settings, {});
    EXPECT_GE(report.p_WP.y, radius_m - 1e-9);
}

/// A new servo does the same with the state that the last one left, its scene at another address.
TEST(ContactRebind, AMachineGoesOnWithItsSceneElsewhere) {
    const Scene scene = busy_scene();
    for (const Mode mode : all_modes) {
        for (const int stop : {1, 35, 110, 200, 330}) {
            ContactMachine machine;
            std::vector<Position> path;
            machine.record_path(&path);
            machine.reset(scene, {-0.02, 4e-3}, 0.0);
            for (int i = 0; i < stop; ++i) {
                const Position hand{-0.02 + 1e-4 * i, 4e-3 - 1e-4 * (i % 80)};
                (void)machine.step(hand, i / 15 % 2 == 0 ? 0.0 : 2.5, giving_way(mode), {});
            }
            ContactMachine moved = machine;
            {
                const Scene elsewhere = busy_scene();
                ASSERT_TRUE(moved.rebind(&elsewhere)) << static_cast<int>(mode) << ' ' << stop;
                path.clear();
                const auto found = session(moved, mode);
                EXPECT_TRUE(path.empty());  // belonged to the other machine
                const auto expected = session(machine, mode);
                for (std::size_t i = 0; i < found.size(); ++i) expect_equal(found[i], expected[i]);
            }
        }
    }
}

TEST(ContactRebind, WithoutASceneThereIsNoForceUntilTheReset) {
    const Scene scene = scene_of(map_of({outline({{-0.05, 0.0}, {0.05, 0.0}}, false)}));
    ContactMachine machine;
    machine.reset(scene, {0.0, 0.001}, 0.0);
    EXPECT_GT(machine.step({0.0, -0.002}, 0.0, {}, {}).force.y, 0.9);
    ASSERT_TRUE(machine.rebind(nullptr));
    EXPECT_EQ(machine.step({0.0, -0.002}, 0.0, {}, {}).force, Force{});
    machine.reset(scene, {0.0, 0.001}, 0.0);
    EXPECT_GT(machine.step({0.0, -0.002}, 0.0, {}, {}).force.y, 0.9);
}

/// The other scene lacks what the machine touches.
TEST(ContactRebind, AMachineDoesNotFitAnotherScene) {
    const Outline low = outline({{-0.05, -0.02}, {0.05, -0.02}}, false);
    const Outline bent = outline({{-0.02, 0.02}, {0.0, 0.0}, {0.02, 0.02}}, false);
    const Scene both = scene_of(map_of({low, bent}));
    const Scene one = scene_of(map_of({low}));
    const Scene straight = scene_of(map_of({low, outline({{-0.02, 0.02}, {0.0, 0.0}}, false)}));
    for (const Mode mode : all_modes) {
        for (const Position hand : {Position{0.005, 0.004}, Position{0.0, -0.001}}) {
            ContactMachine machine;
            machine.reset(both, {0.0, 0.012}, 0.0);
            ASSERT_EQ(machine.step(hand, 0.0, settings_of(mode), {}).outline, 1);
            ContactMachine same = machine;
            EXPECT_TRUE(same.rebind(&both)) << static_cast<int>(mode);
            ContactMachine other = machine;
            EXPECT_FALSE(other.rebind(&one)) << static_cast<int>(mode);
            // In the corner a wall holds by both edges; a groove's bead lies on the first alone.
            const bool is_on_first = mode != Mode::wall && hand.x == 0.0;
            other = machine;
            EXPECT_EQ(other.rebind(&straight), is_on_first) << static_cast<int>(mode);
        }
    }
    ContactMachine free;
    free.reset(both, {0.0, 0.012}, 0.0);
    EXPECT_EQ(free.step({0.0, 0.015}, 0.0, {}, {}).outline, -1);
    EXPECT_TRUE(free.rebind(&one));
}

}  // namespace
}  // namespace touchline
