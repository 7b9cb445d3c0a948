// Where a line goes straight on over a vertex, nothing may be felt.
#include "haptics/contact/contact_machine.h"
#include "tests/haptics/scenes.h"

#include <gtest/gtest.h>

namespace touchline {
namespace {

using scenes::map_of;
using scenes::outline;

ContactSettings settings_of(double radius_m) {
    return {Mode::wall, 1000.0, 0.0, radius_m, 0.003};
}

TEST(Joint, ADiscThatComesDownBesideAVertexOfAStraightLineStaysAboveIt) {
    const Outline line = outline({{-0.002, 0}, {-0.001, 0}, {0, 0}, {0.001, 0}, {0.002, 0}}, false);
    for (const double radius : {0.0, 5e-5, 1e-3}) {
        const Scene scene = build_scene(map_of({line}), {}, radius).value();
        for (double aside = 1e-14; aside < 1e-7; aside *= 1.25) {
            for (const double x : {aside, -aside}) {
                ContactMachine machine;
                machine.reset(scene, {x, 0.002}, 0.0);
                const Position below{x, -0.001};
                const ContactReport report = machine.step(below, 0.0, settings_of(radius), {});
                ASSERT_GT(report.p_WP.y, 0.99 * radius) << radius << " " << x;
                ASSERT_NEAR(report.p_WP.x, x, 1e-12) << radius << " " << x;
            }
        }
    }
}

}  // namespace
}  // namespace touchline
