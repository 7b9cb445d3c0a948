// Operates every screen with two switches, one to move and one to select, or with one if moving
// goes by itself (accessibility IN-9). After the items of a screen come Repeat, Back and Help as
// items; Back does not if the last item is called so too.
// Threads: values and pure functions.
#pragma once

#include "app/visit/screen_model.h"

#include <optional>
#include <string>

namespace touchline {

enum class SwitchEvent : std::uint8_t { move, select, tick };

struct SwitchScan {
    /// Empty: on the items of the screen; else on one of the roles after them.
    std::optional<KeyRole> role;
    std::string title;     // of the current screen; another screen starts at its items
    double since_s = 0.0;  // time of the last move
    int rounds = 0;        // full rounds without a selection; automatic moving stops after two
};

struct SwitchStep {
    SwitchScan scan;
    std::optional<KeyRole> press;  // treat it as a press of that key
    std::string said;              // the role that Select would press; empty: the screen says it
};

/// `scan_s`: how long each item waits before it moves on by itself; 0: never. A press of the move
/// switch restarts a stopped scan where it was. Where every key does the same, both switches press
/// one and nothing moves by itself: a handle that leads is not stopped, and a question is not
/// answered.
[[nodiscard]] SwitchStep step_switches(const SwitchScan& scan, SwitchEvent event,
                                       const SpokenScreen& screen, double scan_s, double now_s,
                                       const Language& language);

}  // namespace touchline
