#include "tests/machines/sim/kiosk/simulation.h"

#include <algorithm>
#include <utility>

namespace touchline {
namespace {

/// Tries smaller plans and remembers the smallest that fails in the same way.
class Shrinking {
  public:
    Shrinking(const Plan& failing, const RunPlan& run) : best_(failing), run_(run) {
        failure_ = run_(failing);
    }

    Plan smallest() {
        if (!failure_) return best_;
        drop_kinds();
        drop_late_faults();
        return best_;
    }

  private:
    bool keep(const PlanOptions& options) {
        Plan plan = make_plan(options);
        const auto failure = run_(plan);
        if (!failure || failure->checker != failure_->checker) return false;
        best_ = std::move(plan);
        failure_ = failure;
        return true;
    }

    void drop_kinds() {
        for (std::size_t i = 0; i < sim_fault_count; ++i) {
            const std::uint64_t bit = bit_of(static_cast<SimFault>(i));
            const bool is_there = std::ranges::any_of(best_.causes, [i](const auto& cause) {
                return static_cast<std::size_t>(cause.fault) == i;
            });
            PlanOptions fewer = best_.options;
            fewer.faults &= ~bit;
            if (!is_there)
                best_.options = fewer;
            else
                (void)keep(fewer);
        }
    }

    /// Goes back from the last fault and leaves out that fault and all after it.
    void drop_late_faults() {
        while (!best_.causes.empty()) {
            PlanOptions earlier = best_.options;
            earlier.until_s = best_.causes.back().at_s;
            if (!keep(earlier)) return;
        }
    }

    Plan best_;
    RunPlan run_;
    std::optional<SimFailure> failure_;
};

}  // namespace

Plan shrunk(const Plan& failing, const RunPlan& run) {
    return Shrinking(failing, run).smallest();
}

Plan shrunk(const Plan& failing) {
    return shrunk(failing, [](const Plan& plan) { return simulate(plan).failure; });
}

}  // namespace touchline
