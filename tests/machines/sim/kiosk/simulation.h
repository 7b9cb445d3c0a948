// A whole site in one thread on a virtual clock: kiosk, guard, servo, board, hand, visitors and
// staff, and whatever goes wrong, all of it from a plan; and the smallest plan that still fails.
// Threads: one; a call starts no other.
#pragma once

#include "tests/machines/sim/kiosk/figures.h"
#include "tests/machines/sim/kiosk/plan.h"
#include "tests/machines/sim/kiosk/servo_life.h"

#include <functional>

namespace touchline {

/// Runs the plan until its end or the first failure. The same plan gives the same hashes.
[[nodiscard]] SimFigures simulate(const Plan& plan, Sabotage sabotage = Sabotage::none);

/// Returns how a plan fails, if it does.
using RunPlan = std::function<std::optional<SimFailure>(const Plan&)>;

/// Shrinks a plan that fails: fewer kinds of faults, no fault after the one that matters. Takes as
/// long as many simulations. Drops one kind after the other, then the last fault again and again,
/// as long as the same checker finds something.
[[nodiscard]] Plan shrunk(const Plan& failing, const RunPlan& run);

/// Shrinks a plan by simulation.
[[nodiscard]] Plan shrunk(const Plan& failing);

}  // namespace touchline
