#include "haptics/guidance/guidance.h"

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double step_m = 1e-6;

TEST(Frame, NothingInsideAndInwardsOutside) {
    const Area area;
    EXPECT_EQ(frame_push(area, {0.0579, -0.0419}, 500.0).force, Force{});
    const Force right = frame_push(area, {0.060, 0.0}, 500.0).force;
    EXPECT_NEAR(right.x, -1.0, 1e-9);
    EXPECT_EQ(right.y, 0.0);
    const Force corner = frame_push(area, {-0.059, -0.043}, 500.0).force;
    EXPECT_NEAR(corner.x, 0.5, 1e-9);
    EXPECT_NEAR(corner.y, 0.5, 1e-9);
}

TEST(Frame, IsNeverStifferThanTheLoopBears) {
    EXPECT_NEAR(frame_push({}, {0.060, 0.0}, 200.0).force.x, -0.4, 1e-9);
    EXPECT_NEAR(frame_push({}, {0.059, 0.0}, 5000.0).force.x, -0.5, 1e-9);
    EXPECT_NEAR(frame_push({}, {0.1, 0.0}, 500.0).force.x, -most_frame_N, 1e-9);
}

TEST(Frame, ForceIsTheSlopeOfWhatIsStored) {
    for (const double x_m : {0.0585, 0.0600, 0.0620, 0.0700}) {
        const double before_J = frame_push({}, {x_m - step_m, 0.0}, 500.0).stored_J;
        const double after_J = frame_push({}, {x_m + step_m, 0.0}, 500.0).stored_J;
        const double force_N = frame_push({}, {x_m, 0.0}, 500.0).force.x;
        EXPECT_NEAR((after_J - before_J) / (2.0 * step_m), -force_N, 1e-6) << x_m;
    }
}

}  // namespace
}  // namespace touchline
