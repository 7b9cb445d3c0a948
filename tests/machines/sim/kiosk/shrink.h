// Finds the smallest plan that still fails: fewer kinds of faults, no fault after the one that
// matters. Threads: pure functions; each takes as long as many simulations.
#pragma once

#include "tests/machines/sim/kiosk/figures.h"
#include "tests/machines/sim/kiosk/plan.h"

#include <functional>

namespace touchline {

/// Returns how a plan fails, if it does.
using RunPlan = std::function<std::optional<SimFailure>(const Plan&)>;

/// Shrinks a plan that fails. Drops one kind after the other, then the last fault again and again,
/// as long as the same checker finds something.
[[nodiscard]] Plan shrunk(const Plan& failing, const RunPlan& run);

/// Shrinks a plan by simulation.
[[nodiscard]] Plan shrunk(const Plan& failing);

}  // namespace touchline
