// What is to happen in one simulated house, all of it from a seed.
// Threads: values and pure functions.
#pragma once

#include "tests/sim/kiosk/fault_kind.h"

#include <cstdint>
#include <string>
#include <vector>

namespace touchline {

struct PlannedVisit {
    double at_s = 0.0;
    double length_s = 0.0;  // after which the visitor says goodbye, or walks away
    std::uint64_t seed = 0;
};

struct PlannedCause {
    double at_s = 0.0;
    SimFault fault = SimFault::short_send;
    double span_s = 0.0;  // it lasts, or is late
    std::uint64_t seed = 0;
};

struct PlanOptions {
    std::uint64_t seed = 1;
    double span_s = 3600.0;             // of the house's time
    std::uint64_t faults = all_faults;  // kinds that may be in it
    double until_s = 1e9;               // no fault begins later: to find the ones that matter
};

struct Plan {
    PlanOptions options;
    std::vector<PlannedVisit> visits;  // by time, far enough apart
    std::vector<PlannedCause> causes;  // by time
};

/// Each kind of fault draws from dice of its own: leaving one out changes nothing of the others.
/// Of every seed some kinds stay away altogether, and of one in eight all do.
[[nodiscard]] Plan make_plan(const PlanOptions& options);

/// For people, a line each.
[[nodiscard]] std::string text_of(const Plan& plan);

}  // namespace touchline
