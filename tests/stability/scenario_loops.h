// The torture geometry of the stability scenarios felt through the whole shipped loop: device,
// encoders, delay, hands.
// Threads: pure functions; measure_all() uses all processors.
#pragma once

#include "tests/bench/contact/torture.h"

#include <string>
#include <string_view>
#include <vector>

namespace touchline::stability {

/// Those of the bench (S02, S06, S08, S10), and flat lines (S01), a convex vertex (S03), a polygon
/// (S04), doubled edges (S11) and tremor (S14).
[[nodiscard]] const std::vector<bench::Torture>& loop_scenarios();

struct ScenarioCase {
    std::size_t scenario = 0;  // of loop_scenarios()
    std::string hand;          // of hand_by_name()
    double delay_periods = 0.0;
};

struct ScenarioResult {
    int handle_through = 0;     // times that the handle itself went through: nothing holds it
    int let_through = 0;        // times that the proxy did
    double extent_steps = 0.0;  // of the tip in the last 0.5 s, at rest, in encoder steps
    double ripple_N = 0.0;      // of the force then
    double largest_N = 0.0;
    double least_gain = 1.0;  // of the stability monitor
    double generated_J = 0.0;
    double bound_J = 0.0;
};

/// All scenarios, four hands, delays of 0, 1 and 2 periods.
[[nodiscard]] std::vector<ScenarioCase> scenario_cases();

/// The default device at 1 kHz with its default stiffness, a point as proxy, level 0.
[[nodiscard]] ScenarioResult measure(const ScenarioCase& each);

[[nodiscard]] std::vector<ScenarioResult> measure_all(const std::vector<ScenarioCase>& cases);

inline constexpr std::string_view scenario_columns =
    "group,scenario,hand,delay_periods,handle_through,let_through,extent_steps,ripple_N,largest_N,"
    "least_gain,"
    "generated_J,bound_J";

[[nodiscard]] std::string csv_line(const ScenarioCase& each, const ScenarioResult& result);

}  // namespace touchline::stability
