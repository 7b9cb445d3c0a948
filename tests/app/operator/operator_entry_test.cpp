// Tests the way to the operator's screens: keys and PIN.
#include "tests/app/operator/operator_rig.h"

#include <gtest/gtest.h>

namespace touchline {
namespace {

using R = KeyRole;
using P = OperatorPlace;

TEST(OperatorEntry, IsASequenceWithinFiveSeconds) {
    OperatorRig rig;
    rig.press({R::help, R::up, R::up, R::down, R::down});
    EXPECT_EQ(rig.state.place, P::closed);
    rig.now_s += 4.0;
    rig.press(R::select);
    EXPECT_EQ(rig.state.place, P::closed) << "too slow";
    rig.press({R::help, R::up, R::down, R::down, R::select});
    EXPECT_EQ(rig.state.place, P::closed) << "one is missing";
    rig.press({R::help, R::help, R::up, R::up, R::down, R::down, R::select});
    EXPECT_EQ(rig.state.place, P::new_pin) << "a key too much before it does no harm";
    EXPECT_EQ(rig.count<Say>(), 1) << "what the visitor hears is the visitor's until then";
}

TEST(OperatorEntry, IsOfTheOperatorsKeyboardWhereOneIsSet) {
    OperatorRig rig;
    rig.is_device_allowed = false;
    rig.enter();
    EXPECT_EQ(rig.state.place, P::closed);
    rig.is_device_allowed = true;
    rig.enter();
    EXPECT_EQ(rig.state.place, P::new_pin);
    rig.is_device_allowed = false;
    const std::string taken = rig.state.pin.taken;
    rig.press(R::repeat);
    EXPECT_EQ(rig.state.pin.taken, taken) << "nor does another keyboard type the PIN";
}

TEST(OperatorPin, IsChosenAtTheFirstStartAndAskedForAfterIt) {
    OperatorRig rig;
    rig.enter();
    rig.enter_pin("4711");
    EXPECT_EQ(rig.state.place, P::new_pin_again);
    rig.enter_pin("4712");
    EXPECT_EQ(rig.state.place, P::new_pin) << "they were not the same";
    rig.enter_pin("4711");
    rig.enter_pin("4711");
    EXPECT_EQ(rig.state.place, P::status);
    rig.press(R::back);
    EXPECT_EQ(rig.state.place, P::home);
    rig.press(R::back);
    EXPECT_EQ(rig.state.place, P::closed);
    EXPECT_EQ(rig.count<Leave>(), 1);
    rig.enter();
    EXPECT_EQ(rig.state.place, P::pin);
    rig.enter_pin("4712");
    EXPECT_EQ(rig.state.place, P::pin);
    rig.enter_pin("4711");
    EXPECT_EQ(rig.state.place, P::status);
}

TEST(OperatorPin, IsSaidInHeadphonesAndClickedWithoutThemButForItsLength) {
    OperatorRig rig;
    rig.enter();
    EXPECT_EQ(rig.heard().find("Plug in headphones"), std::string::npos);
    rig.press({R::up, R::up, R::up, R::select});
    EXPECT_EQ(rig.heard(), "1\n2\n3\n1 digit\n");
    rig.is_private = false;
    rig.press({R::down, R::select, R::back});
    EXPECT_EQ(rig.heard(), "2 digits\n0 digits\n");
    EXPECT_EQ(rig.count<Click>(), 1);
    rig.press({R::up, R::up, R::up, R::help});
    const std::string heard = rig.heard();
    EXPECT_NE(heard.find("Plug in headphones to hear the digits."), std::string::npos) << heard;
    EXPECT_NE(heard.find("Entered so far, 0 digits"), std::string::npos) << heard;
}

TEST(OperatorPin, ADigitIsShownWhileItTurnsAndADotOnceItIsAccepted) {
    for (const bool is_private : {false, true}) {
        OperatorRig rig;
        rig.is_private = is_private;
        rig.enter();
        rig.press({R::up, R::up});
        EXPECT_EQ(rig.shown, "2");
        rig.press(R::select);
        EXPECT_EQ(rig.shown, "• ");
        rig.press(R::down);
        EXPECT_EQ(rig.shown, "• 0");
        rig.press(R::back);
        EXPECT_EQ(rig.shown, "• ");
        rig.press(R::back);
        EXPECT_EQ(rig.shown, "");
    }
}

TEST(OperatorPin, EightDigitsAreEnoughAndANinthIsNone) {
    OperatorRig rig;
    rig.enter();
    for (int i = 0; i < 9; ++i) rig.press({R::up, R::select});
    EXPECT_EQ(rig.state.pin.taken, "11111111");
    rig.press(R::select);
    EXPECT_EQ(rig.state.place, P::new_pin_again);
}

TEST(OperatorPin, TooShortOrTakenBackIsNone) {
    OperatorRig rig;
    rig.enter();
    rig.enter_pin("123");
    EXPECT_EQ(rig.state.place, P::new_pin);
    EXPECT_NE(rig.heard().find("A PIN has 4 to 8 digits."), std::string::npos);
    rig.press({R::down, R::select, R::up, R::back});
    EXPECT_EQ(rig.state.pin.taken, "1230");
    rig.press(R::back);
    EXPECT_EQ(rig.state.pin.taken, "");
    rig.press(R::back);
    EXPECT_EQ(rig.state.place, P::closed);
}

TEST(OperatorPin, FiveWrongOnesLockForGrowingTimes) {
    PinTries tries;
    for (int i = 0; i < 4; ++i) tries = after_wrong_pin(tries, 100.0);
    EXPECT_EQ(tries.locked_until_s, 0.0);
    double before_s = 0.0;
    for (int i = 0; i < 12; ++i) {
        tries = after_wrong_pin(tries, 100.0);
        const double lock_s = tries.locked_until_s - 100.0;
        EXPECT_GE(lock_s, std::min(2.0 * before_s, 3600.0));
        EXPECT_GE(lock_s, 60.0);
        EXPECT_LE(lock_s, 3600.0);
        before_s = lock_s;
    }
}

/// A restart would forget such a try, so it must cost its time at once.
TEST(OperatorPin, AWrongOneThatCouldNotBeNotedLocks) {
    PinTries tries = after_wrong_pin({}, 100.0, false);
    EXPECT_EQ(tries.locked_until_s, 160.0);
    tries = after_wrong_pin(tries, 200.0, false);
    EXPECT_EQ(tries.locked_until_s, 320.0);
}

TEST(OperatorPin, ARestartCountsTheWholeWaitAnew) {
    EXPECT_EQ(tries_after_restart(4, 10.0).locked_until_s, 0.0);
    EXPECT_EQ(tries_after_restart(5, 10.0).locked_until_s, 70.0);
    EXPECT_EQ(tries_after_restart(most_wrong_pins, 10.0).locked_until_s, 3610.0);
}

}  // namespace
}  // namespace touchline
