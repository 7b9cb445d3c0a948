// Homing and the nudge test with the driver, an emulated board and a person who does what is said.
#include "app/device/procedures.h"

#include "tests/app/device/person.h"
#include "tests/sim/board/board_rig.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// Waiting moves the rig's time on.
class RigClock final : public Clock {
  public:
    explicit RigClock(VirtualTime& time) : time_(time) {}

    [[nodiscard]] std::int64_t now_ns() override { return std::llround(time_.now_s * 1e9); }

    void sleep_until(std::int64_t t_ns) override {
        time_.now_s = std::max(time_.now_s, 1e-9 * static_cast<double>(t_ns));
    }

  private:
    VirtualTime& time_;
};

/// A rig whose person hears what is said.
struct Visit {
    explicit Visit(const BoardTruth& truth = {})
        : person(std::make_shared<Person>(truth.profile)), rig(truth, {}, {}, person) {}

    Procedure procedure() {
        return {*rig.driver, clock, [this] { return !is_stop_wanted; },
                [this](const std::string& words) { person->hear(words, rig.time.now_s); }};
    }

    std::shared_ptr<Person> person;
    BoardRig rig;
    RigClock clock{rig.time};
    bool is_stop_wanted = false;
};

bool was_heard(const Visit& visit, const std::string& what) {
    return std::any_of(visit.person->heard.begin(), visit.person->heard.end(),
                       [&](const auto& line) { return line.find(what) != std::string::npos; });
}

double worst_angle_rad(Visit& visit) {
    const JointAngles read = visit.rig.tick({}).value();
    const JointAngles off = read - visit.rig.board.true_angles();
    return std::max(std::abs(off.x), std::abs(off.y));
}

TEST(Procedures, HomingPutsRightABoardThatWasSetUpInTheMiddle) {
    Visit visit;
    ASSERT_TRUE(visit.rig.driver->open().has_value());
    visit.rig.tick_for(0.1, {});
    EXPECT_GT(worst_angle_rad(visit), 0.3);
    ASSERT_TRUE(home(visit.procedure(), Calibration{}).has_value());
    visit.rig.tick_for(0.1, {});
    EXPECT_LT(worst_angle_rad(visit), 0.01);
    EXPECT_EQ(visit.rig.held(), JointTorques{});
}

TEST(Procedures, HomingMeasuresAScaleThatIsOffByPerCent) {
    BoardTruth truth;
    truth.scale_error = {0.05, -0.04};
    Visit visit(truth);
    ASSERT_TRUE(visit.rig.driver->open().has_value());
    const auto found = home(visit.procedure(), std::nullopt);
    ASSERT_TRUE(found.has_value());
    EXPECT_NEAR(found->scale.x, 1.0 / 1.05, 0.006);
    EXPECT_NEAR(found->scale.y, 1.0 / 0.96, 0.006);
    EXPECT_TRUE(was_heard(visit, "measured"));
    visit.rig.tick_for(0.1, {});
    EXPECT_LT(worst_angle_rad(visit), 0.01);
}

TEST(Procedures, HomingNoticesSwappedPlugsAndGoesOn) {
    BoardTruth truth;
    truth.are_plugs_swapped = true;
    Visit visit(truth);
    ASSERT_TRUE(visit.rig.driver->open().has_value());
    const auto found = home(visit.procedure(), Calibration{});
    ASSERT_TRUE(found.has_value());
    EXPECT_TRUE(found->are_motors_swapped);
    EXPECT_TRUE(was_heard(visit, "swapped"));
    visit.rig.tick_for(0.1, {});
    EXPECT_LT(worst_angle_rad(visit), 0.01);
}

TEST(Procedures, HomingEndsWhenStoppedUnpluggedOrOutOfTime) {
    Visit stopped;
    ASSERT_TRUE(stopped.rig.driver->open().has_value());
    stopped.is_stop_wanted = true;
    EXPECT_FALSE(home(stopped.procedure(), Calibration{}).has_value());

    Visit unplugged;
    ASSERT_TRUE(unplugged.rig.driver->open().has_value());
    unplugged.rig.board.unplug();
    const auto ended = home(unplugged.procedure(), Calibration{});
    ASSERT_FALSE(ended.has_value());
    EXPECT_NE(ended.error().line.find("unplugged"), std::string::npos);

    Visit slow;
    ASSERT_TRUE(slow.rig.driver->open().has_value());
    Procedure hasty = slow.procedure();
    hasty.longest_s = 2.0;
    const auto late = home(hasty, Calibration{});
    ASSERT_FALSE(late.has_value());
    EXPECT_NE(late.error().line.find("too long"), std::string::npos);
}

TEST(Procedures, TheNudgeTestSeesPowerPlugsAndItsOwnEnd) {
    const auto verdict_of = [](bool has_power, bool is_swapped) {
        BoardTruth truth;
        truth.hand = no_hand;
        truth.have_motors_power = has_power;
        truth.are_plugs_swapped = is_swapped;
        Visit visit(truth);
        EXPECT_TRUE(visit.rig.driver->open().has_value());
        const auto verdict = nudge(visit.procedure());
        EXPECT_EQ(visit.rig.held(), JointTorques{});
        return verdict.value();
    };
    EXPECT_EQ(verdict_of(true, false), NudgeVerdict::works);
    EXPECT_EQ(verdict_of(false, false), NudgeVerdict::no_power);
    // Motor and encoder of a plug go together: a swap shows in homing, where the arms are looked
    // at.
    EXPECT_EQ(verdict_of(true, true), NudgeVerdict::works);
}

}  // namespace
}  // namespace touchline
