// What the kiosk carries out of a visit, and what it tells it, with all its parts.
#include "tests/app/kiosk/kiosk_world.h"

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(Kiosk, SP1_AKeyBeginsAVisitWithSpeechAtOnce) {
    KioskWorld world;
    world.run(5.0);
    const auto before = world.heard().things.size();
    const double pressed_s = world.now_s();
    world.press(KeyRole::select);
    world.run(0.3);
    ASSERT_GT(world.heard().things.size(), before);
    EXPECT_FALSE(world.heard().text_since(before).empty());
    EXPECT_LE(world.heard().things[before].at_s - pressed_s, 0.3);
    EXPECT_TRUE(is_visit_on(world.kiosk().visit()));
}

}  // namespace
}  // namespace touchline
