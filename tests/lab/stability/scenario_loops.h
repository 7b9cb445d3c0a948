// The torture geometry of the stability scenarios, felt through the whole loop: device, encoders,
// delay, hands; by the shipped step and by simpler controllers.
// Threads: pure functions; measure_all() uses all processors.
#pragma once

#include "tests/lab/stability/loop_controllers.h"

#include <string>
#include <string_view>
#include <vector>

namespace touchline::stability {

struct ScenarioCase {
    std::size_t scenario = 0;  // of loop_scenarios()
    std::size_t method = 0;    // of loop_methods()
    std::string hand;          // of loop_hand()
    double delay_periods = 0.0;
    double asked = 1.0;  // stiffness, as a multiple of the default; the shipped loop limits it
};

struct ScenarioResult {
    int handle_through = 0;     // times that the handle itself went through: nothing holds it
    int let_through = 0;        // times that the proxy went through
    double extent_steps = 0.0;  // of the tip in the last 0.5 s, at rest, in encoder steps
    double ripple_N = 0.0;      // of the force then
    double largest_N = 0.0;
    double least_gain = 1.0;  // of the stability monitor
    double generated_J = 0.0;
    double bound_J = 0.0;
};

/// Returns all scenarios that a method of loop_methods() can run, with eight hands and delays of 0,
/// 1 and 2 periods.
[[nodiscard]] std::vector<ScenarioCase> scenario_cases(std::size_t method, double asked);

/// Whether at rest, pressed or not, the tip moves by more than two encoder steps and the force by
/// more than 0.02 N rms.
[[nodiscard]] bool buzzes(const ScenarioResult& result);

/// Uses the default device with its default stiffness at 1 kHz. A local model's spring runs four
/// times as often, and its delay counts its own periods.
[[nodiscard]] ScenarioResult measure(const ScenarioCase& each);

[[nodiscard]] std::vector<ScenarioResult> measure_all(const std::vector<ScenarioCase>& cases);

inline constexpr std::string_view scenario_columns =
    "group,scenario,method,hand,delay_periods,asked,handle_through,let_through,extent_steps,ripple_"
    "N,"
    "buzzes,largest_N,least_gain,generated_J,bound_J";

[[nodiscard]] std::string csv_line(const ScenarioCase& each, const ScenarioResult& result);

}  // namespace touchline::stability
