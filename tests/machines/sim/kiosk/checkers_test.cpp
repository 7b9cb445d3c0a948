// Tests that each checker of ticks finds what it is made for, and nothing if all is well.
#include "tests/machines/sim/kiosk/checkers/force.h"
#include "tests/machines/sim/kiosk/checkers/offers.h"
#include "tests/machines/sim/kiosk/checkers/safety.h"

#include <limits>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// Milliseconds of a session, one after the other.
struct Looks {
    SimFigures figures;
    Findings findings;
    TickRecord tick;
    TickSight sight;

    Looks() { sight.is_hand_on = true; }

    /// Goes on by a millisecond with a tick of the servo.
    const TickSight& next() {
        sight.now_s += 1e-3;
        sight.tick = &tick;
        return sight;
    }

    [[nodiscard]] bool has_found() const { return findings.first().has_value(); }
};

TEST(ForceLimitsChecker, SeesAForceThatIsTooLargeOrGrowsTooFast) {
    const auto found = [](Force force) {
        Looks looks;
        ForceLimitsChecker checker(default_profile());
        looks.tick.force = {0.2, 0.0};
        checker.look(looks.next(), looks.figures, looks.findings);
        looks.tick.force = force;
        checker.look(looks.next(), looks.figures, looks.findings);
        return looks.has_found();
    };
    EXPECT_FALSE(found({0.45, 0.0}));
    EXPECT_FALSE(found({}));
    EXPECT_TRUE(found({0.55, 0.0})) << "0.3 N a tick";
    EXPECT_TRUE(found({3.1, 0.0}));
    EXPECT_TRUE(found({std::numeric_limits<double>::quiet_NaN(), 0.0}));
}

TEST(ForceLimitsChecker, SeesAForceThatTurnsTooFast) {
    Looks looks;
    ForceLimitsChecker checker(default_profile());
    for (int i = 1; i <= 4; ++i) {
        looks.tick.force = {0.25 * i, 0.0};
        checker.look(looks.next(), looks.figures, looks.findings);
    }
    EXPECT_FALSE(looks.has_found());
    looks.tick.force = {-1.0, 0.0};
    checker.look(looks.next(), looks.figures, looks.findings);
    EXPECT_TRUE(looks.has_found());
}

TEST(ForceLimitsChecker, SeesAMotorThatMakesTooMuch) {
    Looks looks;
    ForceLimitsChecker checker(default_profile());
    looks.sight.held = {0.0, -0.115};
    checker.look(looks.next(), looks.figures, looks.findings);
    EXPECT_TRUE(looks.has_found());
}

TEST(BoardTruthChecker, SeesTorqueThatNobodyTold) {
    Looks looks;
    BoardTruthChecker checker;
    looks.tick.torques = {0.03, 0.01};
    checker.look(looks.next(), looks.findings);
    looks.sight.held = {0.03, 0.01};
    looks.tick.torques = {0.031, 0.01};
    checker.look(looks.next(), looks.findings);
    EXPECT_FALSE(looks.has_found()) << "one is on its way";
    looks.sight.held = {0.0, 0.01};
    checker.look(looks.next(), looks.findings);
    EXPECT_FALSE(looks.has_found()) << "a send that was cut";
    looks.sight.held = {0.0, 0.02};
    checker.look(looks.next(), looks.findings);
    EXPECT_TRUE(looks.has_found()) << "nobody told the other motor that";
}

/// Returns true if the checker finds the energy of a force that goes along with a hand for so many
/// millimetres.
bool is_energy_found(double force_N, int millimetres) {
    Looks looks;
    GivenEnergyChecker checker;
    for (int i = 0; i < millimetres; ++i) {
        looks.sight.force_W = {force_N, 0.0};
        checker.look(looks.next(), looks.figures, looks.findings);
        looks.sight.tip.position.x += 1e-3;
    }
    return looks.has_found();
}

TEST(GivenEnergyChecker, SeesAForceThatDrives) {
    EXPECT_FALSE(is_energy_found(1.0, 45));
    EXPECT_TRUE(is_energy_found(1.0, 60));
    EXPECT_FALSE(is_energy_found(-1.0, 60)) << "the hand gives";
}

TEST(ZeroDeadlineChecker, SeesTorqueThatStays) {
    for (const int after_ms : {1, 25}) {
        Looks looks;
        ZeroDeadlineChecker checker;
        looks.sight.held = {0.05, 0.0};
        checker.expect(SimFault::servo_killed, 0.0);
        for (int ms = 1; ms <= 30; ++ms) {
            (void)looks.next();
            if (ms == after_ms) {
                looks.sight.held = {};
                looks.sight.held_since_s = looks.sight.now_s;
            }
            checker.look(looks.sight, looks.figures, looks.findings);
        }
        EXPECT_EQ(looks.has_found(), after_ms == 25);
    }
}

TEST(NoHandChecker, SeesAHandleThatIsDrivenAloneOrPushedForLong) {
    const auto found_after_ms = [](bool is_moving, bool is_hand_on) {
        Looks looks;
        NoHandChecker checker;
        looks.sight.is_hand_on = is_hand_on;
        looks.sight.force_W = {1.0, 0.0};
        looks.sight.tip.velocity = {is_moving ? 0.1 : 0.0, 0.0};
        int ms = 0;
        while (ms < 25'000 && !looks.has_found()) {
            checker.look(looks.next(), looks.findings);
            ++ms;
        }
        return ms;
    };
    EXPECT_NEAR(found_after_ms(true, false), 151, 2);
    EXPECT_NEAR(found_after_ms(false, false), 20'201, 5);
    EXPECT_EQ(found_after_ms(true, true), 25'000) << "somebody holds it";
}

/// Returns true if anything is found when these states follow each other, lasting_s each.
bool is_found(std::initializer_list<ForceState> states, double lasting_s = 0.6) {
    Looks looks;
    SafetyTransitionsChecker checker;
    looks.sight.is_first_tick = true;
    for (const ForceState state : states) {
        looks.tick.force_state = state;
        looks.tick.fault = state == ForceState::fault ? Fault::energy : Fault::none;
        for (double passed_s = 0.0; passed_s < lasting_s; passed_s += 1e-3) {
            checker.look(looks.next(), looks.findings);
            looks.sight.is_first_tick = false;
        }
    }
    return looks.has_found();
}

TEST(SafetyTransitionsChecker, SeesStatesThatCannotFollow) {
    using enum ForceState;
    EXPECT_FALSE(is_found({off, armed, ramp, live, ramp, armed, fault, armed, ramp}));
    EXPECT_TRUE(is_found({off, armed, live}));
    EXPECT_TRUE(is_found({off, ramp}));
    EXPECT_TRUE(is_found({off, armed, ramp, live, armed}));
    EXPECT_TRUE(is_found({off, armed, ramp}, 0.1)) << "armed for too short a time";
}

TEST(SafetyTransitionsChecker, SeesForceWhereThereIsNoneAndAFaultThatGetsEasier) {
    Looks looks;
    SafetyTransitionsChecker checker;
    looks.sight.is_first_tick = true;
    looks.tick.force_state = ForceState::armed;
    looks.tick.force = {0.01, 0.0};
    checker.look(looks.next(), looks.findings);
    EXPECT_TRUE(looks.has_found());

    Looks easier;
    SafetyTransitionsChecker other;
    easier.tick.force_state = ForceState::fault;
    easier.tick.fault = Fault::emergency_stop;
    other.look(easier.next(), easier.findings);
    EXPECT_FALSE(easier.has_found());
    easier.tick.fault = Fault::too_fast;
    other.look(easier.next(), easier.findings);
    EXPECT_TRUE(easier.has_found());
}

/// Returns true if anything is found when the map changes under a hand at rest, to one of that
/// drawing, and the force with it.
bool is_growth_found(double change_N, std::uint64_t drawing, bool is_led = false) {
    Looks looks;
    GrowingLineChecker checker;
    looks.tick.force_state = ForceState::live;
    looks.tick.map_version = 1;
    looks.tick.force = {1.0, 0.0};
    looks.sight.is_led = is_led;
    for (int i = 0; i < 2; ++i) checker.look(looks.next(), 7, looks.figures, looks.findings);
    looks.tick.map_version = 2;
    looks.tick.force.x += change_N;
    checker.look(looks.next(), drawing, looks.figures, looks.findings);
    return looks.has_found();
}

TEST(GrowingLineChecker, SeesALineThatPushesAHandAtRest) {
    EXPECT_FALSE(is_growth_found(0.02, 7));
    EXPECT_TRUE(is_growth_found(0.03, 7));
    EXPECT_FALSE(is_growth_found(-0.5, 8)) << "another drawing fades in";
    EXPECT_FALSE(is_growth_found(0.5, 0)) << "so does a picture";
    EXPECT_FALSE(is_growth_found(0.5, 7, true)) << "a shake acts";
}

}  // namespace
}  // namespace touchline
