// When a hand counts as off: the exact window and threshold.
#include "haptics/safety/hand_presence.h"

#include "tests/haptics/tick.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// The device alone, exactly as described, measured 3 ms late.
class LoneTip {
  public:
    explicit LoneTip(const TipMechanics& tip) : tip_(tip), presence_(tip) {}

    /// Returns true once the hand counts as off.
    bool driven(Force force, int ticks) {
        for (int i = 0; i < ticks; ++i) {
            const double speed = norm(velocity_);
            const Velocity friction =
                speed > 0.0 ? (tip_.viscous_Ns_per_m + tip_.coulomb_N / speed) * velocity_
                            : Velocity{};
            const Velocity pull = along<Velocity>(force, 1.0) - friction;
            rate_ += tick_s / (tick_s + 0.003) * (1.0 / tip_.mass_kg * pull - rate_);
            velocity_ += tick_s * rate_;
            step(force);
        }
        return presence_.is_off();
    }

    /// Goes on at its speed under no force, so that there is nothing to judge by.
    bool coasting(int ticks) {
        rate_ = {};
        for (int i = 0; i < ticks; ++i) step({});
        return presence_.is_off();
    }

    [[nodiscard]] const HandPresence& presence() const { return presence_; }

  private:
    void step(Force force) {
        position_ += along<Position>(velocity_, tick_s);
        (void)presence_.step(force, velocity_, position_, tick_s);
    }

    TipMechanics tip_;
    HandPresence presence_;
    Velocity velocity_, rate_;
    Position position_;
};

TEST(LoneHandle, IsFoundInThreeWindows) {
    LoneTip tip({});
    EXPECT_FALSE(tip.driven({2.0, 0.0}, 29));
    EXPECT_TRUE(tip.driven({2.0, 0.0}, 2));
    EXPECT_TRUE(tip.presence().is_alone());
}

TEST(LoneHandle, ItsFrictionIsTakenIntoAccount) {
    LoneTip rough({.mass_kg = 0.07, .viscous_Ns_per_m = 0.0, .coulomb_N = 1.0});
    EXPECT_TRUE(rough.driven({0.0, 2.0}, 31));
    LoneTip viscous({.mass_kg = 0.07, .viscous_Ns_per_m = 4.0, .coulomb_N = 0.0});
    EXPECT_TRUE(viscous.driven({0.0, 3.0}, 31));
}

/// Below about 0.6 N the noise of the encoders would decide.
TEST(LoneHandle, IsNotJudgedByLittleForce) {
    LoneTip tip({});
    EXPECT_FALSE(tip.driven({0.5, 0.0}, 500));
}

TEST(LoneHandle, IsRememberedForHalfASecondWithoutForce) {
    LoneTip soon({});
    EXPECT_FALSE(soon.driven({2.0, 0.0}, 20));
    EXPECT_FALSE(soon.coasting(400));
    EXPECT_TRUE(soon.driven({2.0, 0.0}, 20));
    LoneTip late({});
    EXPECT_FALSE(late.driven({2.0, 0.0}, 20));
    EXPECT_FALSE(late.coasting(600));
    EXPECT_FALSE(late.driven({2.0, 0.0}, 20));
    EXPECT_TRUE(late.driven({2.0, 0.0}, 20));
    LoneTip in_parts({});  // each pause on its own
    for (int i = 0; i < 2; ++i) {
        EXPECT_FALSE(in_parts.driven({2.0, 0.0}, 10));
        EXPECT_FALSE(in_parts.coasting(300));
    }
    EXPECT_TRUE(in_parts.driven({2.0, 0.0}, 10));
}

TEST(LoneHandle, OneContradictionIsAHand) {
    LoneTip tip({});
    EXPECT_FALSE(tip.driven({2.0, 0.0}, 20));
    LoneTip held = tip;
    HandPresence presence = held.presence();
    for (int i = 0; i < 200; ++i)  // stands still under the same force
        EXPECT_FALSE(presence.step({2.0, 0.0}, {}, {0.01, 1e-3 * i}, tick_s));
}

/// Shaking in one direction is enough, whichever it is.
TEST(StillHandle, ATremorAlongAnyDirectionIsAHand) {
    for (const Position shaken : {Position{1.0, 0.0}, Position{0.0, 1.0}, Position{-0.7, 0.7}}) {
        HandPresence presence({});
        for (int i = 0; i < 25'000; ++i) {
            const double m = 1.5e-4 * std::sin(2.0 * std::numbers::pi * 8.0 * tick_s * i);
            ASSERT_FALSE(presence.step({1.0, 0.0}, {}, m * shaken, tick_s)) << shaken.x;
        }
    }
}

TEST(StillHandle, HalfANewtonIsNotMoreThanHalfANewton) {
    HandPresence at({});
    HandPresence above({});
    for (int i = 0; i < 20'100; ++i) {
        ASSERT_FALSE(at.step({0.5, 0.0}, {}, {}, tick_s));
        (void)above.step({0.501, 0.0}, {}, {}, tick_s);
    }
    EXPECT_TRUE(above.is_off());
    EXPECT_FALSE(above.is_alone());
}

/// A stir below what the tip's counts can tell does not show a hand.
TEST(StillHandle, AHandIsBackOnceItMovesByMoreThanTwoTenthsAndACount) {
    HandPresence presence({.count_m = 3e-4});
    for (int i = 0; i < 20'100; ++i) (void)presence.step({1.0, 0.0}, {}, {}, tick_s);
    ASSERT_TRUE(presence.is_off());
    EXPECT_TRUE(presence.step({}, {}, {4.9e-4, 0.0}, tick_s));
    EXPECT_FALSE(presence.step({}, {}, {0.0, 5.1e-4}, tick_s));
}

}  // namespace
}  // namespace touchline
