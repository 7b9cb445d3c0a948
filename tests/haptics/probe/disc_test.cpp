// R1: a disc in the hand feels what the point proxy with that radius feels, and no torque.

#include "haptics/contact/contact_machine.h"
#include "tests/haptics/probe/hands.h"
#include "tests/haptics/scenes.h"

#include <cmath>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// Slides along the lines of a scene and into them.
Position slow_hand(int k) {
    const double t = 1e-3 * k;
    return {0.03 * std::cos(0.4 * t) + 0.004 * std::sin(3.1 * t),
            0.03 * std::sin(0.4 * t) + 0.004 * std::cos(2.3 * t)};
}

TEST(ProbeDisc, FeelsWhatThePointProxyFeels) {
    constexpr double radius_m = 0.002;
    const Scene scene =
        build_scene(scenes::map_of({scenes::circle(0.028, 96), scenes::square(0.03, 4)}), {},
                    radius_m)
            .value();
    const ProbeShape disc = probes::disc(radius_m);
    ContactSettings settings;
    settings.radius_m = radius_m;
    ContactMachine machine;
    ProbeProxy proxy;
    machine.reset(scene, slow_hand(0), 0.0);
    proxy.reset(disc, scene, {slow_hand(0).x, slow_hand(0).y, 0.0}, 0.0);
    int in_contact = 0;
    for (int k = 0; k < 20000; ++k) {
        const Position hand = slow_hand(k);
        const double angle = std::sin(1e-3 * k);
        const ContactReport expected = machine.step(hand, 0.0, settings, {});
        const ProbeReport felt = proxy.step({hand.x, hand.y, angle}, 0.0, {}, {});
        ASSERT_NEAR(felt.force.x, expected.force.x, 1e-6) << k;
        ASSERT_NEAR(felt.force.y, expected.force.y, 1e-6) << k;
        ASSERT_NEAR(felt.torque_Nm, 0.0, 1e-9) << k;
        in_contact += felt.contact_count > 0 ? 1 : 0;
    }
    EXPECT_GT(in_contact, 8000);
}

}  // namespace
}  // namespace touchline
