// What happens at one simulated site, all of it from a seed. Threads: values and pure functions.
#pragma once

#include "tests/machines/sim/kiosk/fault_kind.h"

#include <cstdint>
#include <string>
#include <vector>

namespace touchline {

struct PlannedVisit {
    double at_s = 0.0;
    double length_s = 0.0;  // then the visitor says goodbye, or walks away
    std::uint64_t seed = 0;
};

struct PlannedCause {
    double at_s = 0.0;
    SimFault fault = SimFault::short_send;
    double span_s = 0.0;  // how long it lasts, or how late it is
    std::uint64_t seed = 0;
};

struct PlanOptions {
    std::uint64_t seed = 1;
    double span_s = 3600.0;             // site time
    std::uint64_t faults = all_faults;  // kinds that may occur
    double until_s = 1e9;               // no fault begins later; narrows down which ones matter
};

struct Plan {
    PlanOptions options;
    std::vector<PlannedVisit> visits;  // by time, far enough apart
    std::vector<PlannedCause> causes;  // by time
};

/// Each kind of fault has its own dice: leaving one out changes nothing for the others. Each seed
/// leaves some kinds out altogether, and one seed in eight leaves all out.
[[nodiscard]] Plan make_plan(const PlanOptions& options);

/// Returns the plan for people, one event a line.
[[nodiscard]] std::string text_of(const Plan& plan);

}  // namespace touchline
