// Tests the operator's detail through the whole kiosk, from the key to the force on the handle.
#include "tests/app/kiosk/blind_operator.h"
#include "tests/app/kiosk/felt_wall.h"

#include <array>
#include <string>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// A line of "A house" and how the hand meets it, starting from a place that is free at every
/// detail.
struct LineOfHouse {
    int detail;
    Position free;
    Position behind;
    Position along;
};

constexpr std::array lines{
    LineOfHouse{1, {-0.0345, -0.005}, {-0.0406, -0.005}, {0.0, -0.004}},   // left wall
    LineOfHouse{2, {-0.018, -0.003}, {-0.018, 0.0046}, {0.004, 0.0}},      // eaves
    LineOfHouse{3, {-0.0345, -0.012}, {-0.0284, -0.012}, {0.0, -0.004}},   // left window
    LineOfHouse{4, {0.0, 0.006}, {0.0, 0.0126}, {0.001, 0.0}},             // round window
    LineOfHouse{5, {-0.027, -0.0125}, {-0.0209, -0.0125}, {0.0, -0.001}},  // its bars
};

class FeltDetail : public testing::TestWithParam<int> {};

/// The visit goes on: lines above the detail are not felt, all others are walls.
TEST_P(FeltDetail, IsEveryValueThatTheOperatorCanSet) {
    WallWorld world;
    BlindVisitor staff(world, 0.2);
    ASSERT_NO_FATAL_FAILURE(open_walls(world, "A house"));
    ASSERT_NO_FATAL_FAILURE(hold_setting(staff, {"How it feels", "Detail of pictures", "Detail"}));
    for (const LineOfHouse& line : lines) {
        SCOPED_TRACE(line.detail);
        ASSERT_NO_FATAL_FAILURE(turn_to_least(staff));
        world.run(1.0);
        lead_hand(world, {line.free.x, 0.0});
        lead_hand(world, line.free);
        for (int detail = 1; detail < GetParam(); ++detail) staff.press(KeyRole::up);
        world.run(2.0);
        EXPECT_EQ(world.kiosk().visit().visitor.felt->order.detail, GetParam());
        const FeltWall felt = feel_wall(world, line.behind, line.along);
        if (line.detail <= GetParam())
            EXPECT_NEAR(felt.stiffness_N_per_m, 500.0, 15.0);
        else
            EXPECT_LT(felt.most_force_N, 0.01);
    }
    EXPECT_EQ(open_screen(world.kiosk().visit()), VisitScreen::help) << "nothing was moved";
    EXPECT_EQ(world.kiosk().force().fault, Fault::none);
}

INSTANTIATE_TEST_SUITE_P(All, FeltDetail, testing::Range(1, 6));

}  // namespace
}  // namespace touchline
