// What the shipped loop must withstand: a wall over all devices, rates, delays, hands and faults,
// full factorial; and torture geometry through the whole loop, by the shipped step and by simpler
// controllers. Threads: pure functions; measure_all() uses all processors.
#pragma once

#include "tests/lab/stability/loop_controllers.h"
#include "tests/lab/stability/shipped_loop.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace touchline::stability {

/// The hands that a loop must withstand.
inline constexpr std::array loop_hands{"none",
                                       "light",
                                       "normal",
                                       "relaxed arm",
                                       "stiff arm",
                                       "light + bad skin",
                                       "normal + bad skin",
                                       "arm + bad skin"};

/// Returns one of them, as hand_by_name(), except "none": a soft spring presses and nothing damps.
[[nodiscard]] const HandModel& loop_hand(const std::string& name);

struct FactorialCase {
    std::string profile;
    double period_s = 1e-3;
    double delay_periods = 0.0;
    std::string hand;          // of loop_hands
    std::string fault;         // none, scale, friction, noise, late or all
    bool is_stiffest = false;  // the operator asks for all there is, or for the default
    bool is_upright = false;   // turns the wall, to meet the device from two sides
};

struct FactorialResult {
    double stiffness_N_per_m = 0.0;  // asked for, as limited
    double extent_m = 0.0;           // of the tip in the last 0.5 s, held still
    double extent_steps = 0.0;       // the same in encoder steps
    double ripple_N = 0.0;           // of the force then
    double least_gain = 1.0;         // of the stability monitor
    double generated_J = 0.0;
    double bound_J = 0.0;
    bool is_through = false;  // the proxy came to the other side
};

/// Whether in the end the tip moves by more than 20 um and two encoder steps, and the force by more
/// than 0.02 N rms. Less force is a creep that noise or a returning stiffness drives; less motion
/// is the buzz of one encoder step.
[[nodiscard]] bool shakes(const FactorialResult& result);

/// The kinds that a board drives, the one with motors of its own controllers, and the Inverse3,
/// which has no arms whose scale could be off.
[[nodiscard]] std::vector<DeviceProfile> all_devices();

/// `delays` in periods.
[[nodiscard]] std::vector<FactorialCase> factorial(const std::vector<double>& delays);

/// Presses with 1 N at 0.2 m/s, holds, slides by 20 mm, holds: 4 s.
[[nodiscard]] FactorialResult measure(const FactorialCase& each);

[[nodiscard]] std::vector<FactorialResult> measure_all(const std::vector<FactorialCase>& cases);

inline constexpr std::string_view factorial_columns =
    "profile,period_ms,delay_periods,hand,fault,asked,wall,stiffness_N_per_m,extent_um,extent_"
    "steps,"
    "ripple_N,least_gain,generated_J,bound_J,through,shakes";

[[nodiscard]] std::string csv_line(const FactorialCase& each, const FactorialResult& result);

/// Torture geometry felt through the whole loop: device, encoders, delay, hands.
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
