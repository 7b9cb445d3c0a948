// An operator who uses only the six keys and what is said, also while a visit runs. Threads: one.
#pragma once

#include "tests/app/kiosk/blind_visitor.h"

#include <initializer_list>

namespace touchline {

/// Presses the keys that open the operator's screens.
void enter(BlindVisitor& staff);

/// Enters the digits 1, 2, 3, 4.
void enter_pin(BlindVisitor& staff);

/// Calls enter(), sets a new PIN, goes down to a setting by these names, and holds it.
void hold_setting(BlindVisitor& staff, std::initializer_list<const char*> names);

/// Turns the held setting down to its least value.
void turn_to_least(BlindVisitor& staff);

}  // namespace touchline
