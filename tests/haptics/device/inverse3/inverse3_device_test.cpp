// The driver on the emulated service, on a virtual clock.
#include "haptics/device/inverse3/inverse3_device.h"

#include "haptics/servo/servo_loop.h"
#include "tests/haptics/servo/rigs.h"
#include "tests/haptics/tick.h"
#include "tests/machines/sim/inverse3/arm_rig.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

constexpr DeviceCommand push_right{{1.0, 0.0}, {}, 0.0, 1.0};

double size_N(Space force_N) {
    return std::hypot(force_N.x, force_N.y, force_N.z);
}

struct OpenRig : ArmRig {
    explicit OpenRig(ServiceTruth truth = {}) : ArmRig(std::move(truth)) {
        EXPECT_TRUE(open());
        (void)tick_for(0.1);
    }
};

TEST(Inverse3Device, ThePlaceIsSeenFromAboveInThePicturesFrame) {
    OpenRig rig;
    rig.hand->move_to({0.03, -0.02});
    const auto told = rig.tick_for(2.0);
    ASSERT_TRUE(told && told->p_D);
    EXPECT_FALSE(told->jacobian);
    const Position place = picture_from_device(rig.profile, *told->p_D);
    EXPECT_NEAR(place.x, 0.03, 1e-3);
    EXPECT_NEAR(place.y, -0.02, 1e-3);
}

TEST(Inverse3Device, EveryCornerOfTheAreaIsWithinTheReachOfTheMakersPrograms) {
    const Area area = inverse3_profile().area;
    EXPECT_LT(std::hypot(area.width_m / 2.0, area.height_m / 2.0), 0.100);
}

TEST(Inverse3Device, AForceOnTheHandIsToldInTheServicesAxes) {
    OpenRig rig;
    (void)rig.tick_for(0.05, {turned(Force{0.5, 0.25}), {}, 0.0, 0.0});
    EXPECT_NEAR(rig.service.applied_N().x, 0.5, 1e-4);
    EXPECT_NEAR(rig.service.applied_N().y, 0.25, 1e-4);
    EXPECT_EQ(rig.service.applied_N().z, 0.0) << "nothing holds the plane";
}

TEST(Inverse3Device, TheThirdAxisIsHeldToThePlane) {
    OpenRig rig;
    rig.service.lift(0.004);
    (void)rig.tick_for(0.5, {{}, {}, 0.0, 1.0});
    EXPECT_LT(rig.service.applied_N().z, -0.3);
    EXPECT_NEAR(rig.device->off_plane_m(), rig.service.place_m().z - inverse3_plane_m, 1e-4);
    rig.service.lift(-0.004);
    (void)rig.tick_for(0.5, {{}, {}, 0.0, 1.0});
    EXPECT_GT(rig.service.applied_N().z, 0.3);
}

TEST(Inverse3Device, OffThePlaneNothingIsFeltInIt) {
    OpenRig rig;
    rig.service.lift(0.025);
    (void)rig.tick_for(1.0, push_right);
    EXPECT_GT(rig.device->off_plane_m(), rig.profile.cartesian->spring.off_plane_m);
    EXPECT_EQ(rig.service.applied_N().x, 0.0);
    EXPECT_LT(rig.service.applied_N().z, 0.0);
}

TEST(Inverse3Device, WithoutNewsThereIsNoPlaceAndZeroIsTold) {
    ServiceTruth truth;
    truth.idle_after_s = 1e9;
    OpenRig rig(truth);
    (void)rig.tick_for(0.05, push_right);
    ASSERT_LT(rig.made_D().x, 1.1);
    ASSERT_GT(rig.made_D().x, 0.9);
    rig.link->spoil(AnswerFault::late, 1000, 0.2);
    int ticks_with_a_place = 0;
    while (rig.tick(push_right) && ticks_with_a_place < 100) ++ticks_with_a_place;
    EXPECT_LE(ticks_with_a_place, 5);
    EXPECT_FALSE(rig.device->write(push_right));
    (void)rig.tick_for(longest_arm_silence_s, push_right);
    EXPECT_EQ(rig.made_D(), Force{}) << "20 ms after the last answer";
    rig.link->spoil(AnswerFault::none);
    EXPECT_TRUE(rig.tick_for(1.0, push_right));
    EXPECT_GT(rig.made_D().x, 0.9);
}

TEST(Inverse3Device, UntilThePlaceIsKnownThereIsNone) {
    ServiceTruth truth;
    truth.arms[0].tells_place = false;
    OpenRig rig(truth);
    EXPECT_FALSE(rig.tick_for(0.5, push_right)) << "commands are answered, without a place";
    EXPECT_EQ(rig.device->report().state, ArmState::waiting);
    EXPECT_EQ(rig.made_D(), Force{});
    rig.service.arm().tells_place = true;
    for (int i = 0; i < 10; ++i) {
        const auto told = rig.tick();
        EXPECT_TRUE(!told || norm(*told->p_D - rig.profile.centre) < 1e-3) << "not D's origin";
    }
    EXPECT_EQ(rig.device->report().state, ArmState::ready);
}

TEST(Inverse3Device, APlaceThatWasToldBeforeIsNotNew) {
    OpenRig rig;
    rig.hand->move_to({0.05, 0.0});
    Position before;
    int repeated = 0;
    for (int i = 0; i < 200; ++i) {
        if (i % 20 == 0) rig.link->spoil(AnswerFault::late, 1, 0.0025);
        const auto told = rig.tick();
        ASSERT_TRUE(told && told->p_D);
        EXPECT_TRUE(i == 0 || told->freshness.is_new == (*told->p_D != before)) << i;
        repeated += told->freshness.is_new ? 0 : 1;
        before = *told->p_D;
    }
    EXPECT_GE(repeated, 10);
}

TEST(Inverse3Device, WhatHindersTakesThePlaceAndTheForce) {
    for (bool ArmTruth::*condition :
         {&ArmTruth::has_power, &ArmTruth::is_calibrated, &ArmTruth::is_ready}) {
        OpenRig rig;
        (void)rig.tick_for(0.05, push_right);
        rig.service.arm().*condition = false;
        EXPECT_FALSE(rig.tick_for(0.01, push_right));
        EXPECT_EQ(rig.device->report().state, ArmState::hindered);
        EXPECT_NE(rig.device->report().hindrance, Hindrance::none);
        EXPECT_EQ(rig.made_D(), Force{});
        rig.service.arm().*condition = true;
        EXPECT_TRUE(rig.tick_for(0.05));
    }
}

TEST(Inverse3Device, WhatIsNoNumberIsZeroAndReported) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const DeviceCommand& bad :
         {DeviceCommand{{nan, 0.0}, {}, 0.0, 1.0}, DeviceCommand{{1.0, 0.0}, {}, 0.0, nan}}) {
        OpenRig rig;
        (void)rig.tick_for(0.05, push_right);
        (void)rig.tick_for(0.005, bad);
        EXPECT_EQ(size_N(rig.service.applied_N()), 0.0);
        EXPECT_TRUE(rig.device->report().was_force_not_finite);
    }
}

RC_GTEST_PROP(Inverse3Device, NothingToldIsEverAboveTheLimit, ()) {
    OpenRig rig;
    const auto number = [] {
        return *rc::gen::element(0.0, 0.3, -2.0, 4.0, -1e9, 1e300,
                                 std::numeric_limits<double>::infinity(),
                                 std::numeric_limits<double>::quiet_NaN());
    };
    for (int i = 0; i < 30; ++i) {
        rig.service.lift(0.01 * std::sin(i));
        (void)rig.tick_for(0.01, {{number(), number()}, {}, 0.0, number()});
    }
    for (const AppliedForce& told : rig.service.told_forces())
        RC_ASSERT(size_N(told.force_N) <= rig.profile.force_limit_N + 2e-4);
}

TEST(Inverse3Device, TheEndIsConfirmedByWhatTheServiceSays) {
    OpenRig rig;
    (void)rig.tick_for(0.05, push_right);
    EXPECT_TRUE(rig.device->stop());
    EXPECT_EQ(rig.made_D(), Force{});
    EXPECT_FALSE(rig.device->stop()) << "there is nothing left";
    ServiceTruth clinging;
    clinging.clings = true;
    OpenRig other(clinging);
    (void)other.tick_for(0.05, push_right);
    (void)other.tick_for(0.05);
    EXPECT_FALSE(other.is_taken);
    EXPECT_FALSE(other.device->stop());
}

TEST(Inverse3Device, AServiceThatClosedIsLostForGoodAndAnotherDriverBeginsAnew) {
    OpenRig rig;
    (void)rig.tick_for(0.05, push_right);
    rig.link->close();
    EXPECT_FALSE(rig.tick(push_right));
    EXPECT_EQ(rig.device->report().state, ArmState::lost);
    EXPECT_FALSE(rig.device->write({}));
    rig.connect();
    EXPECT_TRUE(rig.open());
    EXPECT_TRUE(rig.tick_for(0.1, push_right));
    EXPECT_GT(rig.made_D().x, 0.9);
}

TEST(Inverse3Device, AProcessThatFreezesIsLeftToTheService) {
    OpenRig rig;
    (void)rig.tick_for(0.05, push_right);
    rig.link->freeze();
    rig.link->rest(0.15);
    EXPECT_EQ(rig.made_D(), Force{}) << "the emulated one goes idle after 0.1 s";
}

/// The servo's loop on it, with a wall in front of the hand.
struct LoopRig : OpenRig {
    explicit LoopRig(ServiceTruth truth = {}) : OpenRig(std::move(truth)) {
        hand->move_to({0.0, 0.01});
        (void)tick_for(1.0);
        begun_s = now_s;
        exchange.feel(line_scene(0.0));
        run(1.5);
        EXPECT_EQ(exchange.report().force.state, ForceState::live);
    }

    void run(double span_s) {
        for (double left_s = span_s; left_s > 5e-4; left_s -= tick_s) {
            now_s += tick_s;
            loop.tick(now_s - begun_s, 0);
            most_N = std::max(most_N, size_N(service.applied_N()));
        }
    }

    void press(Position to, double span_s) {
        const int steps = static_cast<int>(std::lround(span_s / tick_s));
        for (int i = 1; i <= steps; ++i) {
            hand->move_to(Position{0.0, 0.01} +
                          static_cast<double>(i) / steps * (to - Position{0.0, 0.01}));
            run(tick_s);
        }
        run(0.3);
    }

    ServoExchange exchange;
    Recorder recorder;
    double begun_s = 0.0;
    ServoLoop loop{*device, profile, tick_s, exchange, recorder};
    double most_N = 0.0;
};

TEST(Inverse3Loop, AWallHoldsTheHandInThePlane) {
    ServiceTruth heavy;
    heavy.weight_N = 0.5;  // of the hand on the handle
    LoopRig rig(heavy);
    rig.press({0.0, -0.006}, 0.3);
    const HandState felt = rig.exchange.report().hand;
    EXPECT_EQ(felt.state, ContactState::edge);
    EXPECT_GT(felt.force.y, 0.5);
    EXPECT_NEAR(rig.service.applied_N().y, felt.force.y, 0.02);
    EXPECT_LT(std::abs(rig.device->off_plane_m()), 0.002);
    EXPECT_GT(rig.service.applied_N().z, 0.2) << "it bears a part of the hand";
    EXPECT_LE(rig.most_N, rig.profile.force_limit_N + 2e-4);
}

TEST(Inverse3Loop, AServiceThatFallsSilentIsALostDeviceWithin25ms) {
    ServiceTruth truth;
    truth.idle_after_s = 1e9;
    LoopRig rig(truth);
    rig.press({0.0, -0.006}, 0.3);
    ASSERT_GT(size_N(rig.service.applied_N()), 0.5);
    rig.link->spoil(AnswerFault::late, 10'000, 0.6);
    rig.run(0.025);
    EXPECT_EQ(size_N(rig.service.applied_N()), 0.0);
    EXPECT_EQ(rig.exchange.report().force.fault, Fault::device_lost);
    rig.link->spoil(AnswerFault::none);
    rig.hand->move_to({0.0, 0.01});
    rig.run(3.0);
    EXPECT_EQ(rig.exchange.report().force.state, ForceState::live) << "by the rule of arming";
}

}  // namespace
}  // namespace touchline
