// What every device promises the servo, whatever its protocol: order, units, signs, limits, zero,
// loss and reconnection. Written once and run for each row of rigs.cpp.
#include "config/types/choices.h"
#include "haptics/device/joint_device.h"
#include "haptics/safety/guards.h"
#include "haptics/servo/handle_motion.h"
#include "tests/haptics/device/conformance/device_rig.h"
#include "tests/haptics/tick.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace touchline {

/// For the names of the cases.
void PrintTo(const RigRow& row, std::ostream* out) {
    *out << row.name;
}

namespace {

constexpr Force right{1.0, 0.0};
constexpr std::array<Force, 4> four_ways{Force{1.0, 0.0}, Force{-1.0, 0.0}, Force{0.0, 1.0},
                                         Force{0.0, -1.0}};

class Conformance : public testing::TestWithParam<RigRow> {
  protected:
    void SetUp() override {
        rig_ = GetParam().make();
        ASSERT_NE(rig_, nullptr);
    }

    [[nodiscard]] const RigPromises& promises() const { return GetParam().promises; }

    [[nodiscard]] DeviceRig& rig() { return *rig_; }

    void open() { ASSERT_TRUE(rig_->open()); }

    /// The command that pushes with `force_D` at the place that was read, as the servo makes it.
    [[nodiscard]] DeviceCommand command_of(Force force_D, const DeviceReading& at) const {
        if (!has_joints(rig_->profile())) return {force_D, {}, 0.0};
        if (!at.jacobian) return {};
        return {{}, joint_torques(*at.jacobian, force_D), 0.0};
    }

    /// A command that is not zero, wherever the handle is.
    [[nodiscard]] DeviceCommand push() const {
        if (!has_joints(rig_->profile())) return {right, {}, 0.0};
        return {{}, {0.05, 0.05}, 0.0};
    }

    /// One tick of the servo: zero where nothing is known.
    std::optional<DeviceReading> tick(Force wanted_D = {}) {
        rig_->pass(tick_s);
        return read_and_write(wanted_D);
    }

    std::optional<DeviceReading> read_and_write(Force wanted_D) {
        const auto told = rig_->device().read(rig_->now_s());
        const bool is_placed = told && told->p_D;
        is_taken_ = rig_->device().write(is_placed ? command_of(wanted_D, *told) : DeviceCommand{});
        return told;
    }

    std::optional<DeviceReading> tick_for(double span_s, Force wanted_D = {}) {
        std::optional<DeviceReading> last;
        const int ticks = static_cast<int>(std::lround(span_s / tick_s));
        for (int i = 0; i < ticks; ++i) last = tick(wanted_D);
        return last;
    }

    /// Holds the hand at the middle of the area, so that forces move it little.
    void settle() {
        rig_->move_hand(rig_->profile().centre);
        (void)tick_for(1.0);
    }

    /// Writes zero every tick until the device holds it; returns how long that took.
    [[nodiscard]] double time_to_zero_s() {
        for (int i = 0; i < 200; ++i) {
            (void)tick();
            if (rig_->holds_zero()) return i * tick_s;
            EXPECT_FALSE(is_taken_ && promises().has_motors) << "it says zero before it is";
        }
        return std::numeric_limits<double>::infinity();
    }

    /// Why a force ends. no_ticks: the servo does none any more, and the line stays.
    enum class End : std::uint8_t { zero_wanted, cut, silent, no_ticks };

    /// Pushes, lets that happen in this tenth of a tick, and returns the time until the device
    /// holds zero, to a tenth of a tick.
    [[nodiscard]] double end_of_force_s(End end, int tenth) {
        rig_ = GetParam().make();
        open();
        settle();
        (void)tick_for(0.05, right);
        EXPECT_FALSE(rig_->holds_zero());
        for (int i = 0; i < tenth; ++i) rig_->pass(0.1 * tick_s);
        if (end == End::cut) rig_->cut();
        if (end == End::silent) rig_->fall_silent();
        const double from_s = rig_->now_s();
        for (int i = tenth + 1; !rig_->holds_zero() && i < 10'000; ++i) {
            rig_->pass(0.1 * tick_s);
            if (i % 10 != 0 || end == End::no_ticks) continue;
            (void)read_and_write(end == End::zero_wanted ? Force{} : right);
        }
        return rig_->now_s() - from_s;
    }

    /// The longest of ten moments within a tick is no longer than stated. Both are told in
    /// microseconds for the reliability table.
    void expect_end_of_force(const std::string& cause, End end, double stated_s) {
        double longest_s = 0.0;
        for (int tenth = 0; tenth < 10; ++tenth)
            longest_s = std::max(longest_s, end_of_force_s(end, tenth));
        EXPECT_LE(longest_s, stated_s + 1e-9) << cause;
        RecordProperty(cause, static_cast<int>(std::lround(1e6 * longest_s)));
        RecordProperty(cause + "_stated", static_cast<int>(std::lround(1e6 * stated_s)));
    }

    /// What the servo concludes of a hand that is led through the area.
    struct Seen {
        bool is_too_fast = false;  // or jumped
        double truly_m_per_s = 0.0;
    };

    /// Leads the hand along x at this speed until the handle is through the area. Of every eleven
    /// answers, this many come later by late_s.
    Seen lead(double m_per_s, double late_s, int late) {
        const DeviceProfile& profile = rig().profile();
        const double half_m = 0.45 * profile.area.width_m;
        rig().move_hand(profile.centre - Position{half_m, 0.0});
        (void)tick_for(1.0);
        HandleMotion motion(profile);
        SpeedWatch watch;
        Seen seen;
        Position before = rig().true_p_D();
        for (int i = 0; before.x < profile.centre.x + half_m && i < 1000; ++i) {
            if (i % 11 == 5) rig().slow_answers(late_s, late);
            rig().move_hand(profile.centre + Position{m_per_s * tick_s * i - half_m, 0.0});
            StepInput input;
            input.reading = tick();
            const auto handle = motion.step(profile, input, std::nullopt, tick_s, tick_s);
            const bool is_fast = watch.step(norm(handle.velocity), tick_s);
            seen.is_too_fast = seen.is_too_fast || is_fast || handle.has_jumped || !input.reading;
            seen.truly_m_per_s =
                std::max(seen.truly_m_per_s, norm(rig().true_p_D() - before) / tick_s);
            before = rig().true_p_D();
        }
        return seen;
    }

    /// The chain bounds a five-bar's force, and the device only its motors' torques.
    void expect_within_limit(Force made_D) {
        const DeviceProfile& profile = rig().profile();
        if (!has_joints(profile)) {
            EXPECT_LE(norm(made_D), profile.force_limit_N * (1.0 + 1e-9));
            return;
        }
        const auto angles = inverse(profile.geometry, rig().true_p_D());
        const auto pose = forward(profile.geometry, angles.value());
        const JointTorques torques = joint_torques(pose.value().jacobian, made_D);
        const double most_Nm = std::max(std::abs(torques.x), std::abs(torques.y));
        EXPECT_LE(most_Nm, profile.torque_limit_Nm * 1.001);
        EXPECT_GE(most_Nm, profile.torque_limit_Nm * 0.9) << "and no less than it can";
    }

    std::unique_ptr<DeviceRig> rig_;
    bool is_taken_ = false;
};

TEST_P(Conformance, TellsWhereTheHandleIsInMetresAndTheDevicesFrame) {
    open();
    const Area area = rig().profile().area;
    for (const Position step : {Position{0.3, 0.0}, Position{-0.3, 0.2}, Position{0.0, -0.3}}) {
        const Position there{step.x * area.width_m, step.y * area.height_m};
        rig().move_hand(rig().profile().centre + there);
        const auto told = tick_for(1.5);
        ASSERT_TRUE(told && told->p_D);
        EXPECT_LT(norm(*told->p_D - rig().true_p_D()), promises().place_m);
        EXPECT_LT(norm(*told->p_D - rig().profile().centre - there), 5e-3) << "where the hand is";
    }
}

TEST_P(Conformance, HasJointsOrHasNoneAsItsProfileSays) {
    open();
    settle();
    const auto told = tick();
    ASSERT_TRUE(told && told->p_D);
    EXPECT_EQ(told->jacobian.has_value(), has_joints(rig().profile()));
    if (!told->jacobian) return;
    const auto of_joints = reading_of(rig().profile().geometry, told->joints).p_D;
    EXPECT_LT(norm(of_joints.value() - *told->p_D), 1e-12);
}

TEST_P(Conformance, WhatItTellsIsFresh) {
    open();
    settle();
    const Position to = rig().profile().centre + Position{0.02, 0.01};
    rig().move_hand(to);
    Position before = rig().true_p_D();
    for (int i = 0; i < 500; ++i) {
        const auto told = tick();
        ASSERT_TRUE(told && told->p_D) << i;
        const double speed_m_per_s = norm(rig().true_p_D() - before) / tick_s;
        before = rig().true_p_D();
        // What the speed was meanwhile is known to a tick.
        const double moved_m = speed_m_per_s * (promises().fresh_s + tick_s) + 5e-4;
        ASSERT_LT(norm(*told->p_D - rig().true_p_D()), moved_m + promises().place_m) << i;
    }
}

TEST_P(Conformance, ItsOwnVelocityIsThatOfItsPlaces) {
    open();
    settle();
    rig().move_hand(rig().profile().centre + Position{0.02, -0.01});
    (void)tick_for(0.05);
    const auto early = tick();
    ASSERT_TRUE(early && early->p_D);
    if (!early->velocity_D) return;  // it measures none
    const auto late = tick_for(0.01);
    ASSERT_TRUE(late && late->p_D && late->velocity_D);
    const auto seen = along<Velocity>(*late->p_D - *early->p_D, 1.0 / 0.01);
    EXPECT_GT(norm(seen), 0.02) << "the hand moves";
    EXPECT_LT(norm(*late->velocity_D - seen), 0.05 + 0.25 * norm(seen));
}

TEST_P(Conformance, PushesWithTheForceInNewtonsAndItsDirection) {
    open();
    settle();
    for (const Force wanted : four_ways) {
        (void)tick_for(0.1, wanted);
        const Force made = rig().true_force_D();
        EXPECT_LT(norm(made - wanted), promises().force_share + promises().force_N)
            << wanted.x << ", " << wanted.y;
    }
}

TEST_P(Conformance, TheHandleGoesWhereItIsPushed) {
    open();
    for (const Force wanted : four_ways) {
        settle();
        const Position before = rig().true_p_D();
        const auto told = tick_for(0.2, wanted);
        ASSERT_TRUE(told && told->p_D);
        EXPECT_GT(dot(rig().true_p_D() - before, wanted), 1e-4);
        EXPECT_GT(dot(*told->p_D - before, wanted), 1e-4 - promises().place_m);
    }
}

TEST_P(Conformance, ACommandActsUntilTheNextAndNotBeforeItIsWritten) {
    open();
    settle();
    EXPECT_TRUE(rig().holds_zero());
    (void)tick_for(0.05, right);
    EXPECT_FALSE(rig().holds_zero());
    const Force first = rig().true_force_D();
    (void)tick_for(0.05, -right);
    EXPECT_LT(dot(first, rig().true_force_D()), 0.0);
}

TEST_P(Conformance, NoForceIsAboveTheDevicesLimitAndItsDirectionStays) {
    open();
    settle();
    for (const double wanted_N : {5.0, 100.0, 1e9}) {
        for (const Force way : {right, Force{0.8, 0.6}}) {
            (void)tick_for(0.02, wanted_N * way);
            const Force made = rig().true_force_D();
            EXPECT_GT(dot(made, way), 0.0) << wanted_N;
            const double beside_N = promises().keeps_way ? std::abs(cross(made, way)) : 0.0;
            EXPECT_LT(beside_N, 0.1 * norm(made) + promises().force_N);
            expect_within_limit(made);
            (void)tick_for(0.1);
        }
    }
}

TEST_P(Conformance, WhatIsNoNumberIsZero) {
    open();
    settle();
    (void)tick_for(0.05, right);
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        for (int i = 0; i < 20; ++i) {
            rig().pass(tick_s);
            (void)rig().device().read(rig().now_s());
            (void)rig().device().write({{bad, 0.0}, {0.0, bad}, 0.0});
        }
        EXPECT_TRUE(rig().holds_zero()) << bad;
    }
}

TEST_P(Conformance, ZeroIsThereInTheTimeThatItStatesAndToldOnlyThen) {
    open();
    settle();
    for (int turn = 0; turn < 20; ++turn) {
        (void)tick_for(0.02 + 0.001 * turn, right);
        ASSERT_FALSE(rig().holds_zero());
        EXPECT_LE(time_to_zero_s(), promises().zero_s + 1e-9);
        (void)tick_for(0.02);
        EXPECT_TRUE(is_taken_) << "and says so in the end";
    }
}

TEST_P(Conformance, NoForceBeforeItIsReady) {
    EXPECT_TRUE(rig().holds_zero());
    bool is_ready = false;
    for (int i = 0; i < 1000 && !is_ready; ++i) {
        rig().pass(tick_s);
        ASSERT_TRUE(rig().holds_zero()) << i << ": what was pushed before it was ready";
        is_ready = rig().device().read(rig().now_s()).has_value();
        const bool is_taken = !is_ready && rig().device().write(push());
        EXPECT_FALSE(is_taken) << i;
    }
    EXPECT_NE(is_ready, promises().needs_opening);
}

TEST_P(Conformance, AGarbledAnswerIsNoNewsOrZero) {
    open();
    settle();
    for (unsigned seed = 1; seed <= 50; ++seed) {
        (void)tick_for(0.05, right);
        rig().garble_next(seed);
        for (int i = 0; i < 30; ++i) {
            const auto told = tick(right);
            const Position place = told ? told->p_D.value_or(rig().true_p_D()) : rig().true_p_D();
            ASSERT_LT(norm(place - rig().true_p_D()), 5e-3) << seed << ": a wrong place";
        }
        const auto told = tick_for(0.5, right);
        ASSERT_TRUE(told && told->p_D) << seed << ": it finds its way back";
    }
}

TEST_P(Conformance, AnswersThatAreLateMakeNoHandTooFast) {
    open();
    for (const double late_s : {0.3e-3, 0.7e-3, 1e-3, 1.4e-3, 2e-3}) {
        for (const int late : {1, 3}) {
            const Seen seen = lead(0.62, late_s, late);  // it swings beyond that
            EXPECT_NEAR(seen.truly_m_per_s, 0.92, 0.04);
            EXPECT_FALSE(seen.is_too_fast) << late << " answers by " << late_s;
        }
    }
}

TEST_P(Conformance, AHandThatIsTooFastIsToldAlsoWhileAnswersAreLate) {
    for (const double late_s : {0.0, 0.3e-3, 1e-3, 1.4e-3, 2e-3}) {
        for (const int late : {1, 3, 11}) {
            rig_ = GetParam().make();
            open();
            const Seen seen = lead(3.0, late_s, late);
            EXPECT_GT(seen.truly_m_per_s, 2.0);
            EXPECT_TRUE(seen.is_too_fast) << late << " answers by " << late_s;
        }
    }
}

TEST_P(Conformance, LossIsToldInTimeAndForceIsRefused) {
    open();
    settle();
    (void)tick_for(0.05, right);
    rig().cut();
    (void)tick_for(promises().loss_s, right);
    for (int i = 0; i < 100; ++i) {
        EXPECT_FALSE(tick(right).has_value()) << i;
        EXPECT_FALSE(rig().device().write(push())) << i;
    }
    if (!promises().free_s) return;
    rig().pass(*promises().free_s);
    EXPECT_TRUE(rig().holds_zero()) << "its motors are free by themselves";
}

TEST_P(Conformance, SilenceIsTheLossOfItAndEndsTheForce) {
    open();
    settle();
    (void)tick_for(0.05, right);
    rig().fall_silent();
    const double from_s = rig().now_s();
    while (!rig().holds_zero() && rig().now_s() < from_s + 1.0) (void)tick(right);
    EXPECT_LE(rig().now_s() - from_s, promises().silence_s + 1e-9);
    (void)tick_for(promises().loss_s, right);
    for (int i = 0; i < 100; ++i) {
        EXPECT_FALSE(tick(right).has_value()) << i;
        EXPECT_FALSE(rig().device().write(push())) << i;
        ASSERT_TRUE(rig().holds_zero()) << i;
    }
}

TEST_P(Conformance, ForceEndsInTheTimeThatItStatesWheneverThatIsWanted) {
    if (!promises().has_motors) return;
    expect_end_of_force("zero_wanted", End::zero_wanted, tick_s + promises().zero_s);
    expect_end_of_force("answers_stop", End::silent, promises().silence_s);
    if (promises().free_s) expect_end_of_force("line_cut", End::cut, *promises().free_s);
    if (promises().alone_s) expect_end_of_force("ticks_stop", End::no_ticks, *promises().alone_s);
}

TEST_P(Conformance, ComesBackAfterALossWithoutForce) {
    open();
    settle();
    for (int turn = 0; turn < 3; ++turn) {
        (void)tick_for(0.05, right);
        rig().cut();
        (void)tick_for(0.1);
        rig().join();
        ASSERT_TRUE(rig().open()) << turn;
        EXPECT_TRUE(rig().holds_zero());
        const auto told = tick_for(0.1);
        ASSERT_TRUE(told && told->p_D) << turn;
        EXPECT_TRUE(rig().holds_zero());
        EXPECT_LT(norm(*told->p_D - rig().true_p_D()), promises().place_m);
        (void)tick_for(0.05, right);
        EXPECT_GT(dot(rig().true_force_D(), right), 0.0);
    }
}

TEST_P(Conformance, TheSameCallsGiveTheSameBits) {
    std::array<Position, 2> ends;
    for (Position& end : ends) {
        rig_ = GetParam().make();
        open();
        rig().move_hand(rig().profile().centre + Position{0.01, 0.01});
        (void)tick_for(0.2, right);
        end = rig().true_p_D();
    }
    EXPECT_EQ(ends[0], ends[1]);
}

/// As "UsbBoard" and "usb-board" are.
bool are_alike(std::string_view name, std::string_view make) {
    std::string letters(make);
    std::erase(letters, '-');
    return std::ranges::equal(name, letters, [](unsigned char a, unsigned char b) {
        return std::tolower(a) == std::tolower(b);
    });
}

TEST(RigRows, ThereIsOneForEachMakeThatASettingNames) {
    for (const std::string_view make : device_makes)
        EXPECT_TRUE(std::ranges::any_of(rig_rows(), [make](const RigRow& row) {
            return are_alike(row.name, make);
        })) << make;
}

INSTANTIATE_TEST_SUITE_P(Devices, Conformance,
                         testing::ValuesIn(rig_rows().begin(), rig_rows().end()),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace touchline
