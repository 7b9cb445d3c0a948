// Whether a hand or something else moves the handle, through the whole tick on the simulated
// pantograph.
#include "haptics/safety/hand_work.h"

#include "haptics/device/simulated/simulated_pantograph.h"
#include "tests/haptics/servo/step_bench.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

namespace touchline {
namespace {

constexpr std::array all_modes{Mode::wall, Mode::groove, Mode::ridge, Mode::stay};

/// Stands still, or goes to and fro along the line y = 0 and across it, never faster than told.
class StrollingHand final : public IntendedPath {
  public:
    StrollingHand(Position start, double m_per_s) : start_(start), m_per_s_(m_per_s) {}

    [[nodiscard]] Intention at(double t_s) const override {
        constexpr double half_m = 0.03;
        const double turn = t_s * m_per_s_ / half_m;
        return {start_ + Position{half_m * std::sin(turn), 0.004 * std::sin(0.37 * turn)}, {}};
    }

  private:
    Position start_;
    double m_per_s_;
};

struct HeldLoop {
    HeldLoop(const HandModel& hand, Mode mode, Position start, double m_per_s)
        : device(default_profile(), SimulationOptions{hand},
                 std::make_shared<StrollingHand>(start, m_per_s)) {
        commands.contact.mode = mode;
    }

    /// Passes time; every five seconds the handle asks whether anybody is there, if told to.
    void run(double for_s, bool is_asking) {
        const auto end = ticks + static_cast<std::uint64_t>(for_s / tick_s);
        for (; ticks < end; ++ticks) {
            if (is_asking && ticks % 5000 == 0)
                commands.pattern = {HandlePattern::time_out, commands.pattern.serial + 1};
            const double now_s = tick_s * static_cast<double>(ticks);
            (void)device.write(step->step({now_s, 0, device.read(now_s), commands, scene.get()}));
            furthest_m = std::max(furthest_m, norm(device.tip().position - from));
        }
    }

    [[nodiscard]] std::uint32_t moves() const { return step->report().hand.hand_moves; }

    SimulatedPantograph device;
    std::shared_ptr<const Scene> scene = line_scene(0.0);
    std::unique_ptr<ServoStep> step = std::make_unique<ServoStep>(default_profile(), tick_s);
    ServoCommands commands;
    Position from = device.tip().position;
    double furthest_m = 0.0;
    std::uint64_t ticks = 0;
};

TEST(HandWork, AHandleThatShakesIsNobody) {
    double furthest_m = 0.0;
    for (const Mode mode : all_modes) {
        for (const HandModel& hand : {no_hand, light_hand, normal_hand}) {
            for (const double y_m : {0.0, 0.001, 0.003}) {
                HeldLoop loop(hand, mode, {0.0, y_m}, 0.0);
                loop.run(60.0, true);
                EXPECT_EQ(loop.moves(), 0U) << static_cast<int>(mode) << ", " << y_m;
                furthest_m = std::max(furthest_m, loop.furthest_m);
            }
        }
    }
    EXPECT_GT(furthest_m, 0.004) << "it does move";
}

TEST(HandWork, ALedHandleIsNobody) {
    HeldLoop loop(no_hand, Mode::groove, {0.0, 0.02}, 0.0);
    loop.run(2.0, false);
    loop.commands.guidance = {GuidanceKind::to_place, false, 1, -1, {0.03, 0.0}, 0.04};
    loop.run(10.0, false);
    EXPECT_GT(loop.furthest_m, 0.01) << "it was led";
    EXPECT_EQ(loop.moves(), 0U);
}

/// One centimetre in a second, by the lightest hand.
TEST(HandWork, ASlowLightHandIsSeenWithinSeconds) {
    for (const Mode mode : all_modes) {
        HeldLoop loop(light_hand, mode, {0.0, 0.001}, 0.01);
        loop.run(3.0, false);
        EXPECT_GT(loop.moves(), 0U) << static_cast<int>(mode);
        for (int i = 0; i < 4; ++i) {
            const std::uint32_t before = loop.moves();
            loop.run(10.0, false);
            EXPECT_GT(loop.moves(), before) << static_cast<int>(mode);
        }
    }
}

TEST(HandWork, BetweenTwoShakesAHandIsSeenToo) {
    HeldLoop loop(light_hand, Mode::groove, {0.0, 0.001}, 0.01);
    loop.run(20.0, true);
    EXPECT_GT(loop.moves(), 0U);
}

TEST(HandWork, WithoutForceMotionIsAHands) {
    HandWork work({});
    for (int i = 0; i < 2000; ++i) work.step({}, {1e-5 * i, 0.0}, tick_s);
    EXPECT_GT(work.moves(), 0U);
}

TEST(HandWork, WhatTheForcePushesIsNotAHands) {
    HandWork work({});
    for (int i = 0; i < 2000; ++i) work.step({0.2, 0.0}, {1e-5 * i, 0.0}, tick_s);
    EXPECT_EQ(work.moves(), 0U);
    HandWork against({});
    for (int i = 0; i < 2000; ++i) against.step({-0.2, 0.0}, {1e-5 * i, 0.0}, tick_s);
    EXPECT_GT(against.moves(), 0U);
}

TEST(HandWork, NumbersThatAreNoneChangeNothing) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    HandWork work({});
    work.step({none, 0.0}, {}, tick_s);
    work.step({}, {none, 0.0}, tick_s);
    work.step({}, {}, none);
    work.disturb({none, 0.0});
    for (int i = 0; i < 2000; ++i) work.step({}, {1e-5 * i, 0.0}, tick_s);
    EXPECT_GT(work.moves(), 0U);
}

}  // namespace
}  // namespace touchline
