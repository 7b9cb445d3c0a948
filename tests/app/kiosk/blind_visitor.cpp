#include "tests/app/kiosk/blind_visitor.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr int longest_list = 80;

/// Returns true if any line of what was said begins with this item; a sentence says its item first.
bool names(const std::string& heard, const std::string& item) {
    return ("\n" + heard).find("\n" + item) != std::string::npos;
}

}  // namespace

void BlindVisitor::press(KeyRole role) {
    since_ = world_.heard().things.size();
    const double pressed_s = world_.now_s();
    world_.press(role);
    ++keys_;
    const bool has_answer = world_.heard().things.size() > since_;
    const double answer_s = has_answer ? world_.heard().things[since_].at_s - pressed_s : 1e9;
    slowest_answer_s_ = std::max(slowest_answer_s_, answer_s);
    world_.run(pause_s_);
}

bool BlindVisitor::find(const std::string& item) {
    for (int i = 0; i < longest_list; ++i) {
        if (names(heard(), item)) return true;
        press(KeyRole::down);
    }
    return names(heard(), item);
}

bool BlindVisitor::choose(const std::string& item) {
    press(KeyRole::up);  // coming back to the item with the focus says it
    press(KeyRole::down);
    if (!find(item)) return false;
    press(KeyRole::select);
    return true;
}

bool BlindVisitor::wait_for(const std::string& words, double most_s) {
    for (double waited_s = 0.0; waited_s < most_s; waited_s += 0.25) {
        if (heard().find(words) != std::string::npos) return true;
        world_.run(0.25);
    }
    return false;
}

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
