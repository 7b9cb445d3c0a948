// Tests a visit with a shape in the hand, by the six keys and what is said, through the production
// servo.
#include "tests/app/kiosk/blind_visitor.h"
#include "tests/app/kiosk/kiosk_world.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace touchline {
namespace {

void to_heart(KioskWorld& world, BlindVisitor& visitor) {
    ASSERT_NO_FATAL_FAILURE(open_gallery_picture(visitor, "A heart"));
    world.run(1.0);
}

void offer_shapes(KioskWorld& world) {
    Settings settings;
    settings.offers_shapes = true;
    world.kiosk().set(settings);
}

void take(BlindVisitor& visitor, const std::string& shape) {
    ASSERT_TRUE(visitor.choose("Shape in the hand")) << visitor.heard();
    ASSERT_TRUE(visitor.choose(shape)) << visitor.heard();
}

/// The place where the heart's outline lies to the right of its middle.
Position right_side(KioskWorld& world) {
    Position farthest;
    for (const Outline& outline : world.servo().picture().map->outlines) {
        for (const Position& p : outline.points)
            if (p.x > farthest.x) farthest = p;
    }
    return farthest;
}

TEST(ShapeVisit, IsNotOfferedUnlessTheOperatorDoes) {
    KioskWorld world;
    BlindVisitor visitor(world);
    to_heart(world, visitor);
    EXPECT_FALSE(visitor.find("Shape in the hand"));
}

TEST(ShapeVisit, ABarIsTakenStoppedTurnedAndPutDown) {
    KioskWorld world;
    offer_shapes(world);
    BlindVisitor visitor(world);
    to_heart(world, visitor);
    take(visitor, "a bar");
    const Position side = right_side(world);
    world.servo().hand().move_to({0.0, side.y});
    world.run(2.0);
    const HandState& hand = world.kiosk().hand();
    EXPECT_EQ(hand.shape, HeldShape::bar);
    ASSERT_TRUE(hand.is_shape_placed);
    // The shape's end meets the line before the hand does.
    world.servo().hand().move_to({side.x - 0.005, side.y});
    world.run(1.0);
    EXPECT_NE(hand.state, ContactState::free);
    EXPECT_LT(hand.p_WP.x, side.x - 0.007);
    EXPECT_LT(hand.force.x, -0.3);
    // Turning a shape beside the line presses it against the line.
    ASSERT_TRUE(visitor.choose("Turn it left")) << visitor.heard();
    double most_Nm = 0.0;
    for (int i = 0; i < 5; ++i) {
        visitor.press(KeyRole::select);
        world.run(0.5);
        most_Nm = std::max(most_Nm, std::abs(hand.torque_Nm));
    }
    EXPECT_NE(visitor.heard().find("turned left by 90 degrees"), std::string::npos)
        << visitor.heard();
    EXPECT_GT(most_Nm, 2e-4);
    EXPECT_NEAR(hand.angle_rad, 1.5708, 1e-3);
    EXPECT_LE(world.servo().most_force_N, 3.0);
    EXPECT_EQ(world.kiosk().force().fault, Fault::none);

    world.kiosk().turn_knob(-0.2);
    world.run(0.5);
    EXPECT_NEAR(hand.angle_rad, 1.3708, 1e-3);

    ASSERT_TRUE(visitor.choose("Shape in the hand")) << visitor.heard();
    ASSERT_TRUE(visitor.choose("a point")) << visitor.heard();
    world.run(1.0);
    EXPECT_EQ(hand.shape, HeldShape::none);
    EXPECT_LE(visitor.slowest_answer_s(), 0.3);
}

TEST(ShapeVisit, TheNextVisitorHoldsAPoint) {
    KioskWorld world;
    offer_shapes(world);
    BlindVisitor visitor(world);
    to_heart(world, visitor);
    take(visitor, "a key");
    world.run(1.0);
    EXPECT_EQ(world.kiosk().hand().shape, HeldShape::key);
    world.run(400.0);  // nobody answers
    EXPECT_FALSE(is_visit_on(world.kiosk().visit()));
    EXPECT_EQ(world.kiosk().hand().shape, HeldShape::none);
}

}  // namespace
}  // namespace touchline
