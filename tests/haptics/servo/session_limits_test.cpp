// Whole sessions of every simulated hand: the force never breaks a limit, and no hand that holds
// the handle in ordinary use loses its force.

#include "haptics/device/simulated/simulated_pantograph.h"
#include "haptics/servo/servo_step.h"
#include "tests/haptics/scenes.h"
#include "tests/haptics/servo/rigs.h"
#include "tests/haptics/tick.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

struct Course {
    HandModel hand;
    bool is_wild = false;  // the handle is thrown, samples fail, numbers go wrong
};

/// The results of a session.
struct Seen {
    int ticks = 0;
    int live = 0;
    int faults = 0;
    int hand_off = 0;
    double most_N = 0.0;
    double most_torque_Nm = 0.0;
    double most_given_J = 0.0;  // in a second
};

std::vector<WaypointPath::Waypoint> way(std::mt19937& random, double seconds,
                                        double speed_m_per_s) {
    const auto even = [&random](double most) {
        return std::uniform_real_distribution<double>(-most, most)(random);
    };
    std::vector<WaypointPath::Waypoint> made{{0.0, {0.0, 0.038}}, {0.8, {0.0, 0.038}}};
    while (made.back().t_s < seconds) {
        const Position next{even(0.05), even(0.036)};
        const double way_m = norm(next - made.back().position);
        made.push_back({made.back().t_s + way_m / speed_m_per_s + 1e-3, next});
        if (random() % 3 == 0) made.push_back({made.back().t_s + 2.0, next});  // a rest
    }
    return made;
}

class CourseSession {
  public:
    CourseSession(const Course& course, unsigned seed, double seconds)
        : course_(course),
          random_(seed),
          device_(
              default_profile(), SimulationOptions{.hand = course.hand},
              std::make_shared<WaypointPath>(way(random_, seconds, course.is_wild ? 1.0 : 0.12))) {}

    Seen run(const Scene& scene, double seconds) {
        StepInput input;
        input.scene = &scene;
        for (int k = 0; k * tick_s < seconds; ++k) {
            input.now_s = k * tick_s;
            input.commands.contact.mode = static_cast<Mode>(k / 4000 % 4);
            input.reading = device_.read(input.now_s);
            if (course_.is_wild) disturb(input);
            const DeviceCommand command = step_.step(input);
            check(command.torques);
            (void)device_.write(command);
            if (testing::Test::HasFatalFailure()) return seen_;
        }
        return seen_;
    }

  private:
    void disturb(StepInput& input) {
        const Geometry& links = default_profile().geometry;
        input.commands.is_emergency_stop = random_() % 50'000 == 0;
        if (random_() % 2000 == 0) input.reading.reset();
        if (random_() % 3000 == 0) input.reading = reading_of(links, {2.0, 1.0});
        if (random_() % 20'000 == 0) input.reading = reading_of(links, {NAN, 1.0});
        if (random_() % 1000 == 0) ++input.commands.faults_cleared;
    }

    void check(JointTorques torques) {
        const ForceStatus& status = step_.report().force;
        const HandState& hand = step_.report().hand;
        ASSERT_TRUE(is_finite(hand.force) && is_finite(torques));
        ASSERT_LE(norm(hand.force), limits_.force_N * (1.0 + 1e-12));
        const double torque_Nm = std::max(std::abs(torques.x), std::abs(torques.y));
        ASSERT_LE(torque_Nm, limits_.torque_Nm * (1.0 + 1e-12));
        ASSERT_LE(norm(hand.force) - norm(last_), limits_.rise_N_per_s * tick_s + 1e-12);
        const bool may_jump = hand.force == Force{} || status.limit >= Limit::speed ||
                              status.limited[static_cast<std::size_t>(Limit::torque)] != torque_;
        ASSERT_TRUE(may_jump ||
                    norm(hand.force - last_) <= limits_.change_N_per_s * tick_s + 1e-12);
        if (status.state == ForceState::fault || status.state == ForceState::armed) {
            ASSERT_EQ(hand.force, Force{});
        }
        given_J_ = std::max(0.0, given_J_ * (1.0 - tick_s) + dot(last_, hand.p_WH - place_));
        seen_.most_given_J = std::max(seen_.most_given_J, given_J_);
        seen_.most_N = std::max(seen_.most_N, norm(hand.force));
        seen_.most_torque_Nm = std::max(seen_.most_torque_Nm, torque_Nm);
        ++seen_.ticks;
        seen_.live += status.state == ForceState::live ? 1 : 0;
        seen_.faults += status.state == ForceState::fault ? 1 : 0;
        seen_.hand_off += status.limit == Limit::hand ? 1 : 0;
        last_ = hand.force;
        place_ = hand.p_WH;
        torque_ = status.limited[static_cast<std::size_t>(Limit::torque)];
    }

    Course course_;
    std::mt19937 random_;
    SimulatedPantograph device_;
    ServoStep step_{default_profile(), tick_s};
    ForceLimits limits_ = limits_of(default_profile());
    Seen seen_;
    Force last_;
    Position place_;
    std::uint32_t torque_ = 0;
    double given_J_ = 0.0;
};

Scene ring_and_line() {
    TactileMap map;
    map.outlines.push_back(scenes::circle(0.025, 128));
    Outline line;
    line.points = {{-0.045, -0.02}, {0.045, 0.03}};
    map.outlines.push_back(line);
    map.version = 1;
    return build_scene(map, {}, 0.0).value();
}

void say(const char* what, const Seen& seen) {
    std::cout << "  " << what << ": " << seen.ticks << " ticks, " << seen.live << " live, "
              << seen.faults << " in a fault, " << seen.hand_off << " without a hand; at most "
              << seen.most_N << " N, " << seen.most_torque_Nm << " N m, " << seen.most_given_J
              << " J a second\n";
}

TEST(SessionLimits, EveryHandKeepsItsForceAndNoLimitIsBroken) {
    const Scene scene = ring_and_line();
    for (const HandModel& hand : {light_hand, normal_hand, relaxed_arm, stiff_arm}) {
        for (unsigned seed = 0; seed < 2; ++seed) {
            const Seen seen = CourseSession({hand, false}, seed, 30.0).run(scene, 30.0);
            if (HasFatalFailure()) FAIL() << hand.mass_kg << ", " << seed;
            if (seed == 0) say("a hand", seen);
            EXPECT_EQ(seen.faults, 0) << hand.mass_kg << ", " << seed;
            EXPECT_EQ(seen.hand_off, 0) << hand.mass_kg << ", " << seed;
            EXPECT_GT(seen.live, 27'000);
            EXPECT_GT(seen.most_N, 0.5);
            EXPECT_LT(seen.most_given_J, 0.1) << hand.mass_kg << ", " << seed;
        }
    }
}

/// The wall pushes with all that the motors have, all the way back.
TEST(SessionLimits, AHandThatPushedFarBeyondAWallAndYieldsKeepsItsForce) {
    const auto scene = line_scene(0.03);
    SimulatedPantograph device(
        default_profile(), SimulationOptions{.hand = stiff_arm},
        std::make_shared<WaypointPath>(std::vector<WaypointPath::Waypoint>{{0.0, {0.0, 0.04}},
                                                                           {1.0, {0.0, 0.04}},
                                                                           {2.0, {0.0, -0.04}},
                                                                           {4.0, {0.0, -0.04}},
                                                                           {4.2, {0.0, 0.04}},
                                                                           {6.0, {0.0, 0.04}}}));
    ServoStep step(default_profile(), tick_s);
    double most_N = 0.0;
    for (int k = 0; k < 6000; ++k) {
        StepInput input;
        input.now_s = k * tick_s;
        input.reading = device.read(input.now_s);
        input.scene = scene.get();
        (void)device.write(step.step(input));
        ASSERT_NE(step.report().force.state, ForceState::fault) << k;
        most_N = std::max(most_N, norm(step.report().hand.force));
    }
    EXPECT_GT(most_N, 1.5);
    EXPECT_GT(step.report().force.limited[static_cast<std::size_t>(Limit::damped)], 10U);
    EXPECT_EQ(step.report().force.state, ForceState::live);
}

TEST(SessionLimits, HoldForWhateverIsDoneToTheDevice) {
    const Scene scene = ring_and_line();
    for (const HandModel& hand : {light_hand, normal_hand, stiff_arm}) {
        for (unsigned seed = 0; seed < 2; ++seed) {
            const Seen seen = CourseSession({hand, true}, seed, 30.0).run(scene, 30.0);
            if (HasFatalFailure()) FAIL() << hand.mass_kg << ", " << seed;
            if (seed == 0) say("a wild one", seen);
            EXPECT_GT(seen.faults, 10);
            EXPECT_GT(seen.live, 100);
        }
    }
}

}  // namespace
}  // namespace touchline
