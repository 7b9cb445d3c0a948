// What must hold after every step of the contact machine in wall mode: the paper's states, their
// transitions and what may hold the proxy in each (paper section 4). Judges from outside, from the
// segments as rendered and exact predicates. Threads: pure functions.
#pragma once

#include "haptics/contact/contact_machine.h"
#include "tests/haptics/contact/judge.h"

#include <span>

namespace touchline {

/// A step and the state before it.
struct StepSeen {
    const CurveSet& curves;
    const Judge& judge;
    const ContactSettings& settings;
    double level;
    Position handle;
    ProxyState before;
    ProxyState after;
    ContactReport report;
    std::span<const Position> path;  // way points of the step
};

/// Returns the first rule of motion that the step breaks: no line is crossed, |handle - proxy| does
/// not grow, only allowed transitions happen; nullptr: none.
[[nodiscard]] const char* broken_rule_of_motion(const StepSeen& step);

/// Returns the first of all rules that the step breaks; nullptr: none. A carried step may leave the
/// proxy anywhere on its way, so what holds it there is not checked.
[[nodiscard]] const char* broken_rule(const StepSeen& step);

}  // namespace touchline
