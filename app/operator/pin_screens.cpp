#include "app/operator/operator_turn.h"

#include <cmath>

namespace touchline {
namespace {

/// The digit that is turned to, after a dot for each accepted one: "• • 3".
std::string shown_pin(const PinEntry& pin) {
    std::string text;
    for (std::size_t i = 0; i < pin.taken.size(); ++i) text += "• ";
    return pin.digit ? text + std::to_string(*pin.digit) : text;
}

/// Speaks only if nobody else hears it; else gives one click (accessibility, EN 301 549 5.1.3.8).
void tell_digit(OperatorTurn& turn, int digit) {
    if (turn.world.kiosk.is_private)
        turn.say(std::to_string(digit));
    else
        turn.order(Click{});
    turn.order(Show{shown_pin(turn.state().pin)});
}

void tell_count(OperatorTurn& turn) {
    turn.say(turn.world.language.counted("operator", "{0} digit", "{0} digits",
                                         static_cast<int>(turn.state().pin.taken.size())));
    turn.order(Show{shown_pin(turn.state().pin)});
}

void give_pin(OperatorTurn& turn) {
    Operator& state = turn.state();
    if (state.is_checking) return;
    state.is_checking = true;
    turn.order(CheckPin{state.pin.taken});
    state.pin = {};
}

void compare_pins(OperatorTurn& turn) {
    Operator& state = turn.state();
    const bool is_same = state.pin.taken == state.chosen_pin;
    const std::string chosen = std::move(state.chosen_pin);
    state.pin = {};
    state.chosen_pin.clear();
    if (!is_same)
        return turn.go(OperatorPlace::new_pin,
                       turn.words("The two were not the same. Choose again."));
    state.tries = {};
    turn.order(KeepPin{chosen});
    turn.go(OperatorPlace::status, turn.words("The PIN is saved."));
}

void finish_pin(OperatorTurn& turn) {
    Operator& state = turn.state();
    if (!is_pin(state.pin.taken))
        return turn.say(turn.words("A PIN has 4 to 8 digits. Press Select to accept a digit."));
    if (asks_for_pin(state.place)) return give_pin(turn);
    if (state.place == OperatorPlace::new_pin_again) return compare_pins(turn);
    state.chosen_pin = state.pin.taken;
    state.pin = {};
    turn.go(OperatorPlace::new_pin_again);
}

/// Takes back the digit turned to, then all accepted ones, then leaves: three presses at most.
void take_back(OperatorTurn& turn) {
    Operator& state = turn.state();
    if (state.pin.taken.empty() && !state.pin.digit) {
        const bool is_first = state.place == OperatorPlace::new_pin_again;
        state.chosen_pin.clear();
        if (is_first) return turn.go(OperatorPlace::new_pin);
        if (state.place == OperatorPlace::key_pin) return turn.go(OperatorPlace::house_key);
        // Whoever changes the PIN was let in. Whoever has none yet, or is asked for it, was not.
        const bool is_inside = state.place == OperatorPlace::new_pin && turn.world.has_pin;
        return is_inside ? turn.go(OperatorPlace::upkeep) : turn.leave();
    }
    if (!state.pin.digit) state.pin.taken.clear();
    state.pin.digit.reset();
    tell_count(turn);
}

bool is_locked(OperatorTurn& turn) {
    const double left_s = turn.state().tries.locked_until_s - turn.world.now_s;
    if (!asks_for_pin(turn.state().place) || left_s <= 0.0) return false;
    turn.say(turn.world.language.counted("operator", "Too many wrong PINs. Wait {0} second.",
                                         "Too many wrong PINs. Wait {0} seconds.",
                                         static_cast<int>(std::lround(std::ceil(left_s)))));
    return true;
}

}  // namespace

void press_pin_key(OperatorTurn& turn, KeyRole role) {
    Operator& state = turn.state();
    if (role == KeyRole::help || role == KeyRole::repeat)
        return turn.say(spoken_screen(turn.screen(), turn.world.language));
    if (role == KeyRole::back) return take_back(turn);
    if (is_locked(turn)) return;
    if (role == KeyRole::select) {
        if (!state.pin.digit) return finish_pin(turn);
        state.pin = with_digit_taken(state.pin);
        return tell_count(turn);
    }
    state.pin = turned(state.pin, role == KeyRole::up);
    tell_digit(turn, *state.pin.digit);
}

void judge_pin(OperatorTurn& turn, const PinChecked& checked) {
    Operator& state = turn.state();
    if (!state.is_checking) return;
    state.is_checking = false;
    if (checked.is_right) {
        state.tries = {};
        if (state.place == OperatorPlace::pin) turn.go(OperatorPlace::status);
        if (state.place != OperatorPlace::key_pin) return;
        turn.order(TrustHouseKey{});
        return turn.go(OperatorPlace::several);
    }
    state.tries = after_wrong_pin(state.tries, turn.world.now_s, checked.is_noted);
    if (!asks_for_pin(state.place)) return;
    if (!is_locked(turn)) turn.say(turn.words("That is not the PIN. Try again."));
}

}  // namespace touchline
