// Operators who come in by the six keys and what is said, also while a visit runs.
// Threads: one.
#pragma once

#include "tests/app/kiosk/blind_visitor.h"

#include <initializer_list>

namespace touchline {

/// The keys that open the operator's screens.
void enter(BlindVisitor& staff);

/// Digits 1, 2, 3, 4.
void enter_pin(BlindVisitor& staff);

/// enter(), a new PIN, and down to a setting by these names, which is then held.
void hold_setting(BlindVisitor& staff, std::initializer_list<const char*> names);

/// The setting that is held, down to its least value.
void turn_to_least(BlindVisitor& staff);

}  // namespace touchline
