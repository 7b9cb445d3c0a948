// A drawing that grows under the hand (S15): the next map comes in at full force where the hand
// cannot tell, and waits where it could.
#include "tests/haptics/scenes.h"
#include "tests/haptics/servo/step_bench.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

constexpr std::uint64_t drawing = 7;
constexpr double most_change_N = 0.021;  // of the force in a tick, by a change of the map

using ScenePtr = std::shared_ptr<const Scene>;

ScenePtr scene_with(std::vector<Outline> outlines, std::uint64_t version,
                    std::uint64_t of = drawing) {
    TactileMap map = scenes::map_of(std::move(outlines));
    map.version = version;
    map.drawing = of;
    return std::make_shared<const Scene>(build_scene(map, {}, 0.005).value());
}

Outline line(Position a, Position b) {
    return scenes::outline({a, 0.5 * (a + b), b}, false);
}

Outline ground() {
    return line({-0.05, 0.0}, {0.05, 0.0});
}

/// Presses a millimetre into the line y = 0 from above, at rest.
Bench hand_on_the_ground(const ScenePtr& scene, Mode mode = Mode::wall) {
    Bench bench;
    bench.input.commands.contact.mode = mode;
    bench.input.scene = scene.get();
    bench.run(800);
    EXPECT_EQ(bench.force().state, ForceState::live);
    bench.drag({0.0, 0.01}, {0.0, -0.001});
    bench.run(300);
    return bench;
}

/// The largest change of the force from one tick to the next.
double largest_change_N(Bench& bench, int ticks) {
    double most_N = 0.0;
    for (int i = 0; i < ticks; ++i) {
        const Force before = bench.hand().force;
        most_N = std::max(most_N, norm(bench.run(1).force - before));
    }
    return most_N;
}

TEST(GrowingDrawing, ALineElsewhereComesInAtOnceUnderAPressingHand) {
    for (const double radius_m : {0.0, 0.0014}) {
        const auto first = scene_with({ground()}, 1);
        const auto next = scene_with({ground(), line({-0.03, 0.02}, {0.03, 0.03})}, 2);
        Bench bench;
        bench.input.commands.contact.radius_m = radius_m;
        bench.input.scene = first.get();
        bench.run(800);
        bench.drag({0.0, 0.01}, {0.0, -0.001});
        bench.run(300);
        const Force before = bench.hand().force;
        ASSERT_NEAR(before.y, 500.0 * (0.001 + radius_m), 0.01);
        bench.input.scene = next.get();
        EXPECT_LE(largest_change_N(bench, 1), most_change_N);
        EXPECT_EQ(bench.hand().map_version, 2U);
        EXPECT_EQ(bench.hand().state, ContactState::edge);
        EXPECT_LE(largest_change_N(bench, 500), most_change_N);
        EXPECT_NEAR(norm(bench.hand().force - before), 0.0, 1e-3);
        EXPECT_EQ(bench.force().state, ForceState::live);
    }
}

/// The new line cuts the old one beside the hand, so the old one has other pieces than before.
TEST(GrowingDrawing, ALineThatCrossesTheOneFeltDoesNotLetTheHandThrough) {
    const auto first = scene_with({ground()}, 1);
    const auto next = scene_with({ground(), line({0.004, -0.02}, {0.006, 0.02})}, 2);
    Bench bench = hand_on_the_ground(first);
    bench.input.scene = next.get();
    EXPECT_LE(largest_change_N(bench, 100), most_change_N);
    EXPECT_EQ(bench.hand().map_version, 2U);
    EXPECT_NEAR(bench.hand().p_WP.y, 0.0, 1e-6);
    bench.drag({0.0, -0.001}, {0.02, -0.001});  // the new line stops it
    EXPECT_LT(bench.run(20).p_WP.x, 0.006);
}

/// A line inside the wall, between proxy and handle, is not met before the hand has left.
TEST(GrowingDrawing, ALineBetweenProxyAndHandleChangesNothing) {
    const auto first = scene_with({ground()}, 1);
    const auto next = scene_with({ground(), line({-0.03, -0.0005}, {0.03, -0.0006})}, 2);
    Bench bench = hand_on_the_ground(first);
    bench.input.scene = next.get();
    EXPECT_LE(largest_change_N(bench, 500), most_change_N);
    EXPECT_NEAR(bench.hand().p_WP.y, 0.0, 1e-6);
}

/// A groove would pull the hand to the new line.
TEST(GrowingDrawing, AGrooveBesideARestingHandWaitsUntilItHasLeft) {
    const auto first = scene_with({ground()}, 1);
    const auto next = scene_with({ground(), line({-0.03, 0.011}, {0.03, 0.011})}, 2);
    Bench bench;
    bench.input.commands.contact.mode = Mode::groove;
    bench.input.scene = first.get();
    bench.run(800);
    ASSERT_EQ(bench.force().state, ForceState::live);
    bench.input.scene = next.get();
    EXPECT_EQ(largest_change_N(bench, 500), 0.0);
    EXPECT_EQ(bench.hand().map_version, 1U);
    EXPECT_EQ(bench.force().state, ForceState::live);
    bench.drag({0.0, 0.01}, {0.0, 0.02});
    bench.run(20);
    EXPECT_EQ(bench.hand().map_version, 2U);
    bench.drag({0.0, 0.02}, {0.0, 0.012});
    EXPECT_LT(bench.run(20).force.y, -0.1);  // and it is felt
}

/// The hand leans on a line that is taken away: it stays until the hand has left.
TEST(GrowingDrawing, ALineThatHoldsTheHandIsNotTakenAway) {
    const auto first = scene_with({ground(), line({-0.03, 0.03}, {0.03, 0.03})}, 1);
    const auto next = scene_with({line({-0.03, 0.03}, {0.03, 0.03})}, 2);
    Bench bench = hand_on_the_ground(first);
    bench.input.scene = next.get();
    EXPECT_LE(largest_change_N(bench, 500), most_change_N);
    EXPECT_EQ(bench.hand().map_version, 1U);
    bench.drag({0.0, -0.001}, {0.0, 0.005});
    bench.run(20);
    EXPECT_EQ(bench.hand().map_version, 2U);
    bench.drag({0.0, 0.005}, {0.0, -0.01});
    EXPECT_EQ(bench.run(20).force, Force{});
}

TEST(GrowingDrawing, AMapOfNoDrawingOrOfAnotherFadesIn) {
    for (const std::uint64_t of : {std::uint64_t{0}, drawing + 1}) {
        const auto first = scene_with({ground()}, 1, of == 0 ? 0 : drawing);
        const auto next = scene_with({ground(), line({-0.03, 0.02}, {0.03, 0.03})}, 2, of);
        Bench bench = hand_on_the_ground(first);
        bench.input.scene = next.get();
        EXPECT_EQ(bench.run(80).force, Force{});
        EXPECT_EQ(bench.hand().map_version, 2U);
    }
}

/// While no force acts, nothing has to wait.
TEST(GrowingDrawing, IsTakenAtOnceWithoutForce) {
    const auto first = scene_with({ground()}, 1);
    const auto next = scene_with({line({-0.03, 0.03}, {0.03, 0.03})}, 2);
    Bench bench = hand_on_the_ground(first);
    bench.input.commands.is_force_wanted = false;
    bench.run(200);
    bench.input.scene = next.get();
    EXPECT_EQ(bench.run(2).map_version, 2U);
}

/// Whatever is drawn wherever the hand rests, in every mode: the force never jumps, and a hand at
/// rest is given no energy, because its force stays as it was.
RC_GTEST_PROP(GrowingDrawing, NoLineEverPushesAHandAtRest, ()) {
    const auto mode = *rc::gen::element(Mode::wall, Mode::groove, Mode::ridge);
    const auto coordinate_m =
        rc::gen::map(rc::gen::inRange(-3000, 3000), [](int um) { return 1e-6 * um; });
    const auto place = [&] { return Position{*coordinate_m, *coordinate_m}; };
    std::vector<Outline> outlines{ground()};
    const auto first = scene_with(outlines, 1);
    Bench bench;
    bench.input.commands.contact.mode = mode;
    bench.input.commands.contact.radius_m = *rc::gen::element(0.0, 0.0014);
    bench.input.scene = first.get();
    bench.run(800);
    bench.drag({0.0, 0.01}, {0.0, *rc::gen::element(-0.001, 0.0005, 0.003)});
    bench.run(300);
    const Force rest = bench.hand().force;
    std::vector<ScenePtr> kept{first};
    for (std::uint64_t version = 2; version < 6; ++version) {
        const Position from = place();
        const Position to = place();
        RC_PRE(norm(to - from) > 1e-4);
        outlines.push_back(line(from, to));
        kept.push_back(scene_with(outlines, version));
        bench.input.scene = kept.back().get();
        RC_ASSERT(largest_change_N(bench, 30) <= most_change_N);
    }
    RC_ASSERT(norm(bench.hand().force - rest) <= 4.0 * most_change_N);
}

}  // namespace
}  // namespace touchline
