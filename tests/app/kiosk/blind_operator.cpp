#include "tests/app/kiosk/blind_operator.h"

#include <gtest/gtest.h>

namespace touchline {

void enter(BlindVisitor& staff) {
    for (const KeyRole role :
         {KeyRole::help, KeyRole::up, KeyRole::up, KeyRole::down, KeyRole::down, KeyRole::select})
        staff.press(role);
}

void enter_pin(BlindVisitor& staff) {
    for (int digit = 1; digit <= 4; ++digit) {
        for (int i = 0; i < digit; ++i) staff.press(KeyRole::up);
        staff.press(KeyRole::select);
    }
    staff.press(KeyRole::select);
}

void hold_setting(BlindVisitor& staff, std::initializer_list<const char*> names) {
    enter(staff);
    enter_pin(staff);
    enter_pin(staff);
    for (const char* name : names) ASSERT_TRUE(staff.choose(name)) << staff.heard();
}

void turn_to_least(BlindVisitor& staff) {
    constexpr int most_steps = 100;
    for (int i = 0; i < most_steps; ++i) {
        staff.press(KeyRole::down);
        if (staff.heard().find("It goes no further.") != std::string::npos) return;
    }
    FAIL() << staff.heard();
}

}  // namespace touchline
