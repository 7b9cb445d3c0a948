// A whole site in one thread on a virtual clock: kiosk, guard, servo, board, hand, visitors and
// staff, and whatever goes wrong, all of it from a plan. Threads: one; a call starts no other.
#pragma once

#include "tests/machines/sim/kiosk/figures.h"
#include "tests/machines/sim/kiosk/plan.h"
#include "tests/machines/sim/kiosk/servo_life.h"

namespace touchline {

/// Runs the plan until its end or the first failure. The same plan gives the same hashes.
[[nodiscard]] SimFigures simulate(const Plan& plan, Sabotage sabotage = Sabotage::none);

}  // namespace touchline
