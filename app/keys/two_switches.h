// Every screen with two switches, one to move and one to select, or with one where moving goes by
// itself (accessibility IN-9): after the items of a screen come Repeat, Back and Help as items.
// Threads: values and pure functions.
#pragma once

#include "app/session/screen_model.h"

#include <optional>
#include <string>

namespace touchline {

enum class SwitchEvent : std::uint8_t { move, select, tick };

struct SwitchScan {
    /// On the items of the screen; else on one of the roles after them.
    std::optional<KeyRole> role;
    std::string title;     // of the screen that is walked; another one is walked from its items
    double since_s = 0.0;  // when it moved last
    int rounds = 0;        // around all of it without a selection; by itself it stops after two
};

struct SwitchStep {
    SwitchScan scan;
    std::optional<KeyRole> press;  // to be taken as if that key had been pressed
    std::string said;              // the role that would be pressed; empty: the screen says all
};

/// `scan_s`: how long each item waits before it moves on by itself; 0: it does not. A press of the
/// move switch starts again where it had stopped.
[[nodiscard]] SwitchStep step_switches(const SwitchScan& scan, SwitchEvent event,
                                       const SpokenScreen& screen, double scan_s, double now_s,
                                       const Language& language);

}  // namespace touchline
