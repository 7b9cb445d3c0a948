// Guidance, patterns, frame and ceiling through the whole tick on the simulated pantograph.
#include "haptics/device/simulated/simulated_pantograph.h"
#include "haptics/guidance/guidance.h"
#include "tests/haptics/servo/step_bench.h"

#include <algorithm>
#include <memory>

namespace touchline {
namespace {

/// Means to be where it is, or where it is told to stay.
class LedHand final : public IntendedPath {
  public:
    explicit LedHand(Position start) : meant_(start) {}

    void follow(Position handle) { meant_ += 0.05 * (handle - meant_); }

    void stay(Position p) { meant_ = p; }

    [[nodiscard]] Intention at(double /*t_s*/) const override { return {meant_, {}}; }

  private:
    Position meant_;
};

std::shared_ptr<const Scene> square_scene() {
    TactileMap map;
    Outline square;
    square.points = {{-0.02, -0.02}, {0.02, -0.02}, {0.02, 0.02}, {-0.02, 0.02}};
    square.is_closed = true;
    map.outlines.push_back(square);
    map.version = 1;
    CurveOptions options;
    options.resample = true;
    return std::make_shared<const Scene>(build_scene(map, options, 0.005).value());
}

struct Loop {
    explicit Loop(Position start)
        : hand(std::make_shared<LedHand>(start)),
          device(
              std::make_unique<SimulatedPantograph>(default_profile(), SimulationOptions{}, hand)) {
        run(900);
        EXPECT_EQ(step->report().force.state, ForceState::live);
    }

    void run(int count) {
        for (int i = 0; i < count; ++i) tick();
    }

    const HandState& tick() {
        const double now_s = tick_s * static_cast<double>(ticks++);
        (void)device->write(step->step({now_s, 0, device->read(now_s), commands, scene.get()}));
        const HandState& state = step->report().hand;
        if (is_relaxed) hand->follow(state.p_WH);
        most_N = std::max(most_N, norm(state.force));
        return state;
    }

    void ask(GuidanceKind kind, Position place = {}) {
        commands.guidance = {kind, false, commands.guidance.serial + 1, -1, place, 0.04};
    }

    std::shared_ptr<const Scene> scene = square_scene();
    std::shared_ptr<LedHand> hand;
    std::unique_ptr<SimulatedPantograph> device;
    std::unique_ptr<ServoStep> step = std::make_unique<ServoStep>(default_profile(), tick_s);
    ServoCommands commands;
    bool is_relaxed = true;
    double most_N = 0.0;
    std::uint64_t ticks = 0;
};

TEST(GuidanceLoop, ATourLeadsAHandThroughWallsAndLeavesThemAsTheyWere) {
    Loop loop({0.0, 0.03});  // outside; the tour goes in and out
    loop.ask(GuidanceKind::tour);
    double furthest_m = 0.0;
    for (int i = 0; i < 15'000; ++i) {
        const HandState& state = loop.tick();
        ASSERT_EQ(state.spring_gain, 1.0);  // nothing counts as ringing
        if (state.guidance.phase == GuidancePhase::arrived) break;
        if (!state.guidance.is_on_line) continue;
        const double off_m =
            std::abs(std::max(std::abs(state.p_WH.x), std::abs(state.p_WH.y)) - 0.02);
        furthest_m = std::max(furthest_m, off_m);
    }
    ASSERT_EQ(loop.step->report().hand.guidance.phase, GuidancePhase::arrived);
    EXPECT_LT(furthest_m, 0.0015);
    EXPECT_LE(loop.most_N, 1.3);

    loop.run(500);
    EXPECT_EQ(loop.step->report().hand.mode, Mode::wall);
    // The wall holds again, from the side on which guidance left the hand.
    loop.is_relaxed = false;
    const Position from = loop.device->tip().position;
    for (int i = 0; i < 500; ++i) {
        loop.hand->stay(from + 0.01 * i / 500.0 * from);
        loop.tick();
    }
    for (int i = 0; i < 1'000; ++i) {
        loop.hand->stay((1.5 - 1.0 * i / 1'000.0) * from);
        loop.tick();
    }
    EXPECT_GT(loop.most_N, 0.8);
}

TEST(GuidanceLoop, HA1_AStopIsFeltWithin50ms) {
    Loop loop({0.0, 0.032});
    loop.ask(GuidanceKind::to_place, {0.05, 0.032});
    loop.run(400);
    loop.is_relaxed = false;  // held back
    loop.run(600);
    ASSERT_GT(norm(loop.step->report().hand.force), 0.4);
    loop.ask(GuidanceKind::none);
    loop.run(50);
    EXPECT_LT(norm(loop.step->report().hand.force), 0.005);
    EXPECT_EQ(loop.step->report().hand.guidance.phase, GuidancePhase::stopped);
    loop.run(1'000);
    // It is back where the hand holds it, up to the friction.
    EXPECT_LT(norm(loop.device->tip().position - loop.hand->at(0.0).position), 0.001);
}

TEST(GuidanceLoop, ForceOffAndAnotherPictureStopIt) {
    for (const bool is_picture : {false, true}) {
        Loop loop({0.0, 0.032});
        loop.ask(GuidanceKind::tour);
        loop.run(1'000);
        ASSERT_EQ(loop.step->report().hand.guidance.phase, GuidancePhase::running);
        std::shared_ptr<const Scene> old = loop.scene;
        if (is_picture) {
            loop.scene = line_scene(-0.02, 2);
        } else {
            loop.commands.is_force_wanted = false;
        }
        loop.run(60);
        EXPECT_EQ(loop.step->report().hand.guidance.phase, GuidancePhase::stopped);
        loop.commands.is_force_wanted = true;
        loop.most_N = 0.0;
        loop.run(2'000);
        EXPECT_EQ(loop.most_N, 0.0);
    }
}

TEST(GuidanceLoop, ATourThatIsAskedInAGrooveBringsForceOn) {
    Loop loop({0.0, 0.032});
    loop.commands.contact.mode = Mode::groove;
    loop.commands.is_force_wanted = false;
    loop.is_relaxed = false;
    loop.hand->stay({0.0, 0.0213});  // pulled by more than the force may begin with
    loop.run(300);
    loop.commands.is_force_wanted = true;
    loop.run(800);
    ASSERT_EQ(loop.step->report().force.state, ForceState::armed);
    loop.ask(GuidanceKind::tour);
    loop.run(1'500);
    EXPECT_EQ(loop.step->report().force.state, ForceState::live);
    EXPECT_NE(loop.step->report().hand.guidance.phase, GuidancePhase::stopped);
}

TEST(GuidanceLoop, HA3_EveryPatternIsFeltAndMovesTheHandleNowhere) {
    for (const PatternRow& row : pattern_rows()) {
        Loop loop({0.0, 0.032});
        const Position at = loop.device->tip().position;
        loop.commands.pattern = {row.pattern, 1};
        double furthest_m = 0.0;
        for (int i = 0; i < 1'800; ++i) {
            loop.tick();
            furthest_m = std::max(furthest_m, norm(loop.device->tip().position - at));
        }
        EXPECT_GT(loop.most_N, 0.3);
        EXPECT_LE(loop.most_N, 1.0);
        EXPECT_GT(furthest_m, 2e-5);
        EXPECT_LT(furthest_m, 0.003);
        EXPECT_LT(norm(loop.device->tip().position - at), 0.001);  // up to the friction
        EXPECT_EQ(loop.step->report().hand.guidance.pattern_serial, 1U);
        EXPECT_EQ(loop.step->report().hand.spring_gain, 1.0);
    }
}

TEST(GuidanceLoop, TheFrameIsFeltAtTheEdgeAndCanBeLeftOut) {
    for (const bool has_frame : {true, false}) {
        Loop loop({0.0, 0.032});
        loop.commands.has_frame = has_frame;
        loop.is_relaxed = false;
        for (int i = 0; i < 600; ++i) {
            loop.hand->stay({0.0, 0.032 + 0.016 * i / 600.0});
            loop.tick();
        }
        loop.run(100);
        const Force force = loop.step->report().hand.force;
        if (has_frame) {
            EXPECT_LT(force.y, -0.6);
            EXPECT_LT(loop.device->tip().position.y, 0.0455);
        } else {
            EXPECT_EQ(force, Force{});
        }
    }
}

TEST(GuidanceLoop, IN8_TheOperatorsCeilingHoldsAndRisesSlowly) {
    Bench bench;
    const auto scene = line_scene(0.0);
    bench.input.scene = scene.get();
    bench.input.commands.force_ceiling_N = 0.5;
    bench.run(800);
    bench.drag({0.0, 0.01}, {0.0, -0.003});  // 1.5 N wanted
    bench.run(20);
    EXPECT_NEAR(norm(bench.hand().force), 0.5, 1e-9);
    bench.input.commands.force_ceiling_N = 1.0;
    bench.run(200);
    EXPECT_NEAR(norm(bench.hand().force), 0.7, 0.01);
    bench.run(400);
    EXPECT_NEAR(norm(bench.hand().force), 1.0, 1e-9);
    bench.input.commands.force_ceiling_N = 0.0;
    bench.run(5);
    EXPECT_EQ(norm(bench.hand().force), 0.0);
}

}  // namespace
}  // namespace touchline
