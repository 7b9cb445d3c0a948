#include "haptics/servo/loop_settings.h"

#include <limits>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// A device that no encoder limits.
DeviceProfile fine_device() {
    DeviceProfile profile = find_profile("mk2").value();
    profile.mechanics.viscous_Ns_per_m = 0.1;
    return profile;
}

TEST(LoopSettings, StartFromTheTable) {
    // facts 7.5: 350 at 500 Hz, 700 at 1 kHz, 1500 at 4 kHz.
    EXPECT_NEAR(loop_settings(fine_device(), 2e-3, 0.0).stiffness_N_per_m, 350.0, 3.0);
    EXPECT_NEAR(loop_settings(fine_device(), 1e-3, 1e-3).stiffness_N_per_m, 700.0, 5.0);
    EXPECT_EQ(loop_settings(fine_device(), 2.5e-4, 0.0).stiffness_N_per_m, 1500.0);
    EXPECT_EQ(loop_settings(fine_device(), 1e-3, 0.0).damping_Ns_per_m, 1.5);
    EXPECT_EQ(loop_settings(fine_device(), 2.5e-4, 0.0).damping_Ns_per_m, 2.0);
}

TEST(LoopSettings, LessForALaterLoopAndACoarserEncoder) {
    for (const DeviceProfile& profile : device_profiles()) {
        const LoopSettings prompt = loop_settings(profile, 1e-3, 1e-3);
        const LoopSettings late = loop_settings(profile, 1e-3, 3e-3);
        EXPECT_LT(late.stiffness_N_per_m, prompt.stiffness_N_per_m);
        EXPECT_LT(late.largest_stiffness_N_per_m, prompt.largest_stiffness_N_per_m);
        EXPECT_LE(prompt.stiffness_N_per_m, prompt.largest_stiffness_N_per_m);
        const double encoder = 2.0 * profile.mechanics.coulomb_N / encoder_step_m(profile);
        const double quick = loop_settings(profile, 2.5e-4, 0.0).largest_stiffness_N_per_m;
        EXPECT_LE(quick, encoder);
        EXPECT_LE(quick, 1500.0);
    }
}

TEST(VirtualDamping, ActsAlongTheSpringAndOnlyPushes) {
    const Force spring{0.0, 0.5};
    EXPECT_EQ(damped(spring, {0.3, 0.0}, 1.5), spring);                  // along the wall
    EXPECT_EQ(damped(spring, {0.0, -0.1}, 1.5), (Force{0.0, 0.65}));     // in
    EXPECT_EQ(damped(spring, {0.0, 0.1}, 1.5), (Force{0.0, 0.35}));      // out
    EXPECT_EQ(damped(spring, {0.0, 1.0}, 1.5), (Force{0.0, 0.0}));       // never pulls
    EXPECT_EQ(damped({}, {0.0, -1.0}, 1.5), Force{});                    // nothing in free space
    EXPECT_NEAR(damped({0.0, 0.02}, {0.0, -0.1}, 1.5).y, 0.035, 1e-12);  // little near the surface
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(damped(spring, {nan, 0.0}, 1.5), (Force{0.0, 0.0}));
}

}  // namespace
}  // namespace touchline
