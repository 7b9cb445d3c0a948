// One step of the operator's screens while it is made. For the sources of this folder only.
// Threads: a plain value.
#pragma once

#include "app/operator/operator.h"
#include "app/operator/operator_menu.h"
#include "config/settings/setting_rows.h"

#include <string>
#include <utility>

namespace touchline {

struct OperatorTurn {
    OperatorStep step;
    const OperatorWorld& world;

    [[nodiscard]] Operator& state() { return step.state; }

    [[nodiscard]] SpokenScreen screen() const { return operator_screen(step.state, world); }

    [[nodiscard]] std::string words(const std::string& english) const {
        return world.language.text("operator", english);
    }

    void order(OperatorOrder wanted) { step.orders.push_back(std::move(wanted)); }

    void say(const std::string& text) {
        if (!text.empty()) order(Say{text});
    }

    /// Says the item that has the focus, as it is now.
    void say_item() {
        const SpokenScreen shown = screen();
        if (shown.focus) say(spoken_item(shown, *shown.focus, world.language));
    }

    /// Says its value alone.
    void say_value() {
        const SpokenScreen shown = screen();
        if (shown.focus) say(shown.items[*shown.focus].value);
    }

    /// Opens another screen and says all of it after `first`. Focuses its first item, or the item
    /// of the screen that this came from.
    void go(OperatorPlace place, const std::string& first = "") {
        Operator& now = step.state;
        const OperatorPlace from = now.place;
        if (from == OperatorPlace::live) order(ShowLive{false});
        if (place == OperatorPlace::live) order(ShowLive{true});
        now.place = place;
        now.focus = 0;
        now.is_held = false;
        now.device_words = world.kiosk.device_words;
        now.note = place == OperatorPlace::homing ? world.kiosk.device_words : "";
        const bool is_after_test = from == OperatorPlace::test_step;
        const ItemMeaning left =
            is_after_test ? ItemMeaning{OperatorItem::test, static_cast<std::size_t>(now.test.step)}
                          : ItemMeaning{OperatorItem::place, static_cast<std::size_t>(from)};
        now.focus = place_of(operator_items(now, world), id_of(left)).value_or(0);
        const std::string all = spoken_screen(screen(), world.language);
        say(first.empty() ? all : first + ' ' + all);
    }

    /// Gives the kiosk back to the visitors. Nothing of the operator's stays except the cost of
    /// wrong PINs.
    void leave() {
        if (step.state.place == OperatorPlace::live) order(ShowLive{false});
        Operator closed;
        closed.tries = step.state.tries;
        closed.test.verdicts = step.state.test.verdicts;
        closed.settings = world.settings;
        closed.sound = world.sound;
        step.state = closed;
        say(words("The operator’s screens are closed."));
        order(Leave{});
    }

    void ask(Question question) {
        step.state.question = question;
        go(OperatorPlace::question);
    }
};

/// operator_settings.cpp: Select on an item that has a value; does nothing for any other.
[[nodiscard]] bool select_value(OperatorTurn& turn, const ItemMeaning& meaning);

/// Up and Down while Select holds a setting.
void turn_value(OperatorTurn& turn, const ItemMeaning& meaning, bool is_up);

/// Releases and keeps a held setting. False: another screen asks something first.
[[nodiscard]] bool release_value(OperatorTurn& turn);

/// pin_screens.cpp: the three screens of the PIN.
void press_pin_key(OperatorTurn& turn, KeyRole role);

void judge_pin(OperatorTurn& turn, const PinChecked& checked);

/// operator_step.cpp
void follow_test(OperatorTurn& turn, const SelfTestStep& step);

/// Begins with this step; `is_all`: the others follow. The tests lead back to the open screen.
void begin_tests(OperatorTurn& turn, TestStep first, bool is_all);

/// operator_actions.cpp
void do_action(OperatorTurn& turn, std::size_t action);

void choose_kind(OperatorTurn& turn, std::size_t kind);

/// Handles the answer to the question.
void answer(OperatorTurn& turn, bool is_yes);

}  // namespace touchline
