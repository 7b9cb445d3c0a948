// Every state under every combination of the flags and faults of a tick.

#include "haptics/safety/force_chain.h"
#include "tests/haptics/tick.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr SafetyTimes times;

std::vector<SafetyState> all_states() {
    std::vector<SafetyState> states{{ForceState::off, Fault::none, 0.0, 0.0, 0.0}};
    for (const double quiet_s : {0.0, 0.1, 0.2})
        states.push_back({ForceState::armed, Fault::none, 0.0, quiet_s, 0.0});
    for (const double gain : {0.0, 0.01, 0.5, 0.999})
        states.push_back({ForceState::ramp, Fault::none, gain, 0.0, 2.0});
    states.push_back({ForceState::live, Fault::none, 1.0, 0.0, 2.0});
    for (const FaultRule& rule : fault_rules())
        states.push_back({ForceState::fault, rule.fault, 0.0, 0.0, 0.0});
    return states;
}

/// Bits 0 to 4 are the flags, the eight above them the faults.
SafetyFlags flags_of(unsigned bits) {
    const auto is_set = [bits](unsigned bit) { return (bits >> bit & 1U) != 0; };
    return {is_set(0), is_set(1), is_set(2),
            is_set(3), is_set(4), static_cast<std::uint16_t>(bits >> 5U << 1U)};
}

Fault gravest_of(std::uint16_t faults) {
    Fault found = Fault::none;
    for (const FaultRule& rule : fault_rules())
        if ((faults & bit_of(rule.fault)) != 0) found = rule.fault;
    return found;
}

/// Whether a fault whose conditions are gone may end.
bool may_end(Fault fault, const SafetyFlags& flags) {
    const FaultClears clears = fault_rules()[static_cast<std::size_t>(fault) - 1].clears;
    if (flags.is_cleared || clears == FaultClears::when_gone) return true;
    return clears == FaultClears::on_rearm && !flags.is_wanted;
}

void expect_legal(const SafetyState& before, const SafetyFlags& flags, const SafetyState& after) {
    // Holds in every state.
    ASSERT_TRUE(after.gain >= 0.0 && after.gain <= 1.0);
    ASSERT_LE(after.gain - before.gain, tick_s / times.resume_s + 1e-12);
    ASSERT_EQ(after.state == ForceState::fault, after.fault != Fault::none);
    ASSERT_EQ(after.state == ForceState::live, after.gain == 1.0);
    ASSERT_TRUE(after.gain == 0.0 || after.state == ForceState::ramp || after.gain == 1.0);
    if (after.state == ForceState::off || after.state == ForceState::fault) {
        ASSERT_EQ(after, (SafetyState{after.state, after.fault, 0.0, 0.0, 0.0}));
    }
    if (after.state == ForceState::armed) {
        ASSERT_EQ(after.rise_per_s, 0.0);
    }
    if (after.state == ForceState::ramp || after.state == ForceState::live) {
        ASSERT_EQ(after.quiet_s, 0.0);
    }
    // Faults come at once and go by their rule; the gravest is reported.
    if (flags.faults != 0) {
        ASSERT_EQ(after.fault, std::max(before.fault, gravest_of(flags.faults)));
        return;
    }
    if (before.state == ForceState::fault) {
        ASSERT_EQ(after.state != ForceState::fault, may_end(before.fault, flags));
        ASSERT_EQ(after.gain, 0.0);
    } else {
        ASSERT_NE(after.state, ForceState::fault);
    }
    // Off if and only if nobody wants force.
    if (after.state != ForceState::fault) {
        ASSERT_EQ(after.state == ForceState::off, !flags.is_wanted);
    }
    // Force comes on only by arming, with a hand and without a push.
    const bool was_silent = before.state == ForceState::off || before.state == ForceState::armed;
    if (was_silent && after.state == ForceState::ramp) {
        ASSERT_EQ(before.state, ForceState::armed);
        ASSERT_GE(before.quiet_s, 0.19);
        ASSERT_TRUE(flags.is_quiet);
        ASSERT_FALSE(flags.is_hand_off);
    }
    // A fade and a hand that is off take force away.
    const bool is_falling = flags.is_fading || flags.is_hand_off;
    if (is_falling && before.gain > 0.0) {
        ASSERT_LT(after.gain, before.gain);
    }
    if (!is_falling && flags.is_wanted && before.state == ForceState::ramp) {
        ASSERT_GT(after.gain, before.gain);
    }
    if (flags.is_hand_off && after.gain == 0.0) {
        ASSERT_NE(after.state, ForceState::ramp);
    }
}

TEST(SafetyState, EveryStateUnderEveryCombinationOfFlags) {
    int tried = 0;
    for (const SafetyState& before : all_states()) {
        for (unsigned bits = 0; bits < (1U << 13U); ++bits) {
            const SafetyFlags flags = flags_of(bits);
            const SafetyState after = next(before, flags, times, tick_s);
            expect_legal(before, flags, after);
            if (testing::Test::HasFatalFailure()) FAIL() << "bits " << bits;
            ++tried;
        }
    }
    EXPECT_EQ(tried, 17 * (1 << 13));
    RecordProperty("states", static_cast<int>(all_states().size()));
    RecordProperty("steps", tried);
}

TEST(SafetyState, TimesAreReachedNotPassed) {
    constexpr SafetyTimes halves{.arm_s = 0.25, .start_s = 1.0, .resume_s = 0.5, .fade_s = 0.125};
    SafetyState state{ForceState::armed, Fault::none, 0.0, 0.125, 0.0};
    state = next(state, {}, halves, 0.125);  // after 0.25 s of quiet it is on its way at once
    EXPECT_EQ(state, (SafetyState{ForceState::ramp, Fault::none, 0.125, 0.0, 1.0}));
    SafetyFlags fading;
    fading.is_fading = true;
    state = next(state, fading, halves, 0.0625);
    EXPECT_EQ(state, (SafetyState{ForceState::ramp, Fault::none, 0.0, 0.0, 2.0}));
    state = next(state, {}, halves, 0.5);
    EXPECT_EQ(state, (SafetyState{ForceState::live, Fault::none, 1.0, 0.0, 2.0}));
    SafetyFlags alone;
    alone.is_hand_off = true;
    EXPECT_EQ(next(state, alone, halves, 0.125),
              (SafetyState{ForceState::armed, Fault::none, 0.0, 0.0, 0.0}));
}

/// A force that ends fades perceptibly: it does not break off.
TEST(SafetyState, ForceFadesWithinFiftyMilliseconds) {
    SafetyState state{ForceState::live, Fault::none, 1.0, 0.0, 2.0};
    SafetyFlags fading;
    fading.is_fading = true;
    for (int i = 0; i < 25; ++i) state = next(state, fading, times, tick_s);
    EXPECT_NEAR(state.gain, 0.5, 1e-9);
    for (int i = 0; i < 26; ++i) state = next(state, fading, times, tick_s);
    EXPECT_EQ(state.gain, 0.0);
}

TEST(SafetyState, TheGraverAFaultIsTheLessEasilyItClears) {
    Fault before = Fault::none;
    FaultClears clears = FaultClears::when_gone;
    for (const FaultRule& rule : fault_rules()) {
        EXPECT_EQ(static_cast<int>(rule.fault), static_cast<int>(before) + 1);
        EXPECT_GE(rule.clears, clears);
        before = rule.fault;
        clears = rule.clears;
    }
    EXPECT_EQ(before, Fault::emergency_stop);
}

/// Corrupted memory may make such a state.
TEST(SafetyState, AStateThatIsNoneIsOff) {
    const SafetyState none{static_cast<ForceState>(force_state_count), Fault::none, 1.0, 0.0, 2.0};
    EXPECT_EQ(next(none, {}, times, tick_s), SafetyState{});
}

TEST(SafetyState, StatesAreEqualInEveryField) {
    const SafetyState state{ForceState::ramp, Fault::none, 0.5, 0.1, 2.0};
    EXPECT_EQ(state, state);
    EXPECT_NE(state, (SafetyState{ForceState::live, Fault::none, 0.5, 0.1, 2.0}));
    EXPECT_NE(state, (SafetyState{ForceState::ramp, Fault::energy, 0.5, 0.1, 2.0}));
    EXPECT_NE(state, (SafetyState{ForceState::ramp, Fault::none, 0.6, 0.1, 2.0}));
    EXPECT_NE(state, (SafetyState{ForceState::ramp, Fault::none, 0.5, 0.2, 2.0}));
    EXPECT_NE(state, (SafetyState{ForceState::ramp, Fault::none, 0.5, 0.1, 2.5}));
}

TEST(SafetyState, NoTimeIsAFault) {
    const SafetyState live{ForceState::live, Fault::none, 1.0, 0.0, 2.0};
    for (const double dt_s : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                              std::numeric_limits<double>::infinity()}) {
        EXPECT_EQ(next(live, {}, times, dt_s).fault, Fault::not_finite) << dt_s;
    }
}

TEST(SafetyState, ALostDeviceThatComesBackIsArmedAndThenLiveByItself) {
    SafetyState state{ForceState::live, Fault::none, 1.0, 0.0, 2.0};
    SafetyFlags lost;
    lost.faults = bit_of(Fault::device_lost);
    state = next(state, lost, times, tick_s);
    EXPECT_EQ(state.fault, Fault::device_lost);
    int ticks = 0;
    for (; state.state != ForceState::live && ticks < 2000; ++ticks)
        state = next(state, {}, times, tick_s);
    EXPECT_NEAR(ticks, 700, 5);
}

}  // namespace
}  // namespace touchline
