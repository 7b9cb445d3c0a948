// The test of motors that have controllers of their own, with a person who lets go of the handle in
// the middle: no force comes before it has passed.
#include "app/force/device/procedures.h"
#include "tests/machines/sim/drives/drive_rig.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

template <class Machine>
class MotorsVisit final : public Clock {
  public:
    explicit MotorsVisit(const DriveTruth& truth) : rig(truth) {}

    std::int64_t now_ns() override { return std::llround(rig.time.now_s * 1e9); }

    void sleep_until(std::int64_t t_ns) override {
        const double until_s = 1e-9 * static_cast<double>(t_ns);
        if (until_s > rig.time.now_s) rig.pass(until_s - rig.time.now_s);
    }

    MotorsProcedure procedure() {
        MotorsProcedure made{*rig.driver, *this, [this] { return rig.time.now_s < 60.0; },
                             [this](const std::string& words) {
                                 if (!words.empty()) heard.push_back(words);
                             }};
        made.mark_force = [this](bool is_asked) { marks.push_back(is_asked); };
        return made;
    }

    DriveRig<Machine> rig;
    std::vector<std::string> heard;
    std::vector<bool> marks;
};

DriveTruth nobody_holds_it() {
    DriveTruth truth;
    truth.hand = no_hand;
    return truth;
}

template <class Machine>
class MotorsProcedures : public testing::Test {};

using VisitMachines = testing::Types<MoteusMachine, OdriveMachine>;
TYPED_TEST_SUITE(MotorsProcedures, VisitMachines);

TYPED_TEST(MotorsProcedures, PassesWhereBothMotorsMoveTheHandleAndEndsInZero) {
    MotorsVisit<TypeParam> visit(nobody_holds_it());
    ASSERT_TRUE(visit.rig.driver->open().has_value());
    const auto tried = try_motors(visit.procedure());
    ASSERT_TRUE(tried.has_value()) << tried.error().line;
    ASSERT_FALSE(visit.heard.empty());
    EXPECT_EQ(visit.heard.front(),
              "Move the handle to the middle and let go of it. It will twitch four times.");
    EXPECT_EQ(visit.rig.held(), JointTorques{});
    EXPECT_NE(std::ranges::find(visit.marks, true), visit.marks.end());
    EXPECT_FALSE(visit.marks.back());
    // The driver is at work, on whatever clock it is read next.
    visit.rig.tick_for(0.1, {0.02, 0.01});
    EXPECT_NEAR(norm(visit.rig.held() - JointTorques{0.02, 0.01}), 0.0, 1e-4);
}

TYPED_TEST(MotorsProcedures, WithoutThePowerOfTheMotorsItSaysSoAndWaits) {
    DriveTruth truth = nobody_holds_it();
    truth.have_motors_power = false;
    MotorsVisit<TypeParam> visit(truth);
    ASSERT_TRUE(visit.rig.driver->open().has_value());
    EXPECT_FALSE(try_motors(visit.procedure()).has_value());
    ASSERT_GE(visit.heard.size(), 2U);
    EXPECT_NE(visit.heard[1].find("turn on the power of the motors"), std::string::npos)
        << visit.heard[1];
}

TYPED_TEST(MotorsProcedures, AControllerThatFailsMeanwhileEndsIt) {
    MotorsVisit<TypeParam> visit(nobody_holds_it());
    ASSERT_TRUE(visit.rig.driver->open().has_value());
    visit.rig.machine.fail(1);
    EXPECT_FALSE(try_motors(visit.procedure()).has_value());
    EXPECT_LT(visit.rig.time.now_s, 1.0);
    EXPECT_EQ(visit.rig.held(), JointTorques{});
}

}  // namespace
}  // namespace touchline
