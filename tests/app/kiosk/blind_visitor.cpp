#include "tests/app/kiosk/blind_visitor.h"

#include <algorithm>
#include <set>

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

}  // namespace touchline
