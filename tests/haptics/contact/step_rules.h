// What must hold after every step of the contact machine in wall mode: the paper's states, their
// transitions and what may hold the proxy in each (paper section 4). Judged from outside, from the
// segments as rendered and exact predicates. Threads: pure functions.
#pragma once

#include "haptics/contact/contact_machine.h"
#include "tests/haptics/contact/judge.h"

#include <span>

namespace touchline {

/// A step and what was there before it.
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

/// The first of the rules of motion that the step breaks: no line is crossed, |handle - proxy| does
/// not grow, only allowed transitions; nullptr: none.
[[nodiscard]] const char* broken_rule_of_motion(const StepSeen& step);

/// The first of all rules that the step breaks; nullptr: none. A carried step may leave the proxy
/// anywhere on its way, so it is not asked what holds it there.
[[nodiscard]] const char* broken_rule(const StepSeen& step);

}  // namespace touchline
