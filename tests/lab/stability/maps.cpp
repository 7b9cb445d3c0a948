#include "tests/lab/stability/maps.h"

#include "tests/lab/stability/for_each_index.h"
#include "tests/lab/stability/hands.h"
#include "tests/lab/stability/limits.h"
#include "tests/lab/stability/linear_loop.h"
#include "tests/lab/stability/wall_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <vector>

#include <fmt/core.h>

namespace touchline::stability {
namespace {

constexpr double still_m = 20e-6;
constexpr double cutoff_Hz = 100.0;

// The hardest come first, so that a wall that fails shows it soon.
const std::array<Excitation, 5> excitations = {{
    {0.0, 0.3, 1.0},
    {0.0, 0.0, 3.0},
    {0.0, 0.1, 1.0},
    {0.0, 0.0, 2.0, 0.5, 1.0},
    {0.0, 0.02, 1.0},
}};

/// None where no stiffness held: a tip without a wall swings for ever, and nothing is felt.
std::vector<Excitation> excitations_of(const Cell& cell, double stiffness_N_per_m) {
    if (!(stiffness_N_per_m > 0.0)) return {};
    if (!cell.knock_m_per_s) return {excitations.begin(), excitations.end()};
    constexpr double press_N = 20.0;  // so hard that the knock never lifts the tip off
    constexpr double never_s = 1e9;
    const double rest_m = press_N / stiffness_N_per_m;
    return {{rest_m, *cell.knock_m_per_s, press_N, never_s, 0.0, -press_N}};
}

/// Returns 2 s, or 60 swings of the tip on the wall if that is longer: soft walls swing slowly.
double span_s(const Cell& cell, double stiffness_N_per_m) {
    const HandModel& hand = cell.loop.hand;
    const double mass_kg = cell.loop.tip.mass_kg + (hand.skin ? 0.0 : hand.mass_kg);
    const double swing_s = 2.0 * std::numbers::pi * std::sqrt(mass_kg / stiffness_N_per_m);
    return std::max(2.0, 60.0 * swing_s);
}

WallTrace render(const Cell& cell, double stiffness_N_per_m, const Excitation& excitation) {
    const Method& chosen = method(cell.method);
    const WallLoop loop = force_loop(chosen, cell.loop);
    return run(loop, excitation, chosen.make(stiffness_N_per_m, cell.damping_Ns_per_m, loop, 0.0),
               span_s(cell, stiffness_N_per_m));
}

/// A ring of constant size wavers, so a motion that has not come to rest must shrink clearly, and
/// twice.
bool is_calm(const Cell& cell, const WallTrace& trace) {
    const double early_m = peak_to_peak_m(trace, 0.1, 0.3);
    const double middle_m = peak_to_peak_m(trace, 0.4, 0.6);
    const double end_m = peak_to_peak_m(trace, 0.8, 1.0);
    if (end_m < std::max(still_m, 2.0 * cell.loop.encoder_step_m)) return true;
    return end_m < 0.97 * middle_m && middle_m < 0.985 * early_m;
}

double ripple_N(const WallTrace& trace) {
    const std::size_t count = trace.force_N.size() / 5;
    const auto begin = trace.force_N.end() - static_cast<std::ptrdiff_t>(count);
    double mean = 0.0;
    for (auto force = begin; force != trace.force_N.end(); ++force) {
        mean += *force / static_cast<double>(count);
    }
    double squares = 0.0;
    for (auto force = begin; force != trace.force_N.end(); ++force) {
        squares += (*force - mean) * (*force - mean);
    }
    return std::sqrt(squares / static_cast<double>(count));
}

/// Returns the limit over the longest window that the adaptive one may use and all shorter ones.
double passive_window(double b_Ns_per_m, double damping, const WallLoop& loop) {
    double least = std::numeric_limits<double>::infinity();
    for (int periods = 1; periods <= 16; ++periods) {
        const auto wall = [&](double stiffness) {
            return slope_damped_spring(stiffness, damping, loop.period_s, periods);
        };
        least = std::min(least, passive_stiffness(wall, b_Ns_per_m, loop.period_s, loop.delay_s));
        if (damping == 0.0) break;
    }
    return least;
}

double passive(const Cell& cell, const WallLoop& loop) {
    const double b_Ns_per_m =
        loop.tip.viscous_Ns_per_m + (loop.hand.skin ? 0.0 : loop.hand.damping_Ns_per_m);
    if (cell.method == "spring + FOAW16") {
        return passive_window(b_Ns_per_m, cell.damping_Ns_per_m, loop);
    }
    const double share =
        cell.method == "spring + LP100" ? low_pass_share(cutoff_Hz, loop.period_s) : 1.0;
    const auto wall = [&](double stiffness) {
        return damped_spring(stiffness, cell.damping_Ns_per_m, loop.period_s, share);
    };
    return passive_stiffness(wall, b_Ns_per_m, loop.period_s, loop.delay_s);
}

constexpr double usual_damping = 2.0;
const std::vector<std::string> compared = {"spring",      "spring + LP100",  "spring + FOAW16",
                                           "local model", "energy observer", "slope bound"};

bool damps(const std::string& method) {
    return method == "spring + LP100" || method == "spring + FOAW16" ||
           method == "spring + difference";
}

/// 1 kHz, no delay, 20 um, 0.05 N of friction, B = 2 if the method damps.
Cell cell_of(const std::string& method, const std::string& hand) {
    Cell cell;
    cell.method = method;
    cell.hand = hand;
    cell.loop.hand = hand_by_name(hand);
    cell.loop.encoder_step_m = 20e-6;
    cell.damping_Ns_per_m = damps(method) ? usual_damping : 0.0;
    return cell;
}

Slice period_and_delay(const std::string& name, double motors_N) {
    Slice slice{name, "stiffness limit against period, by delay, method and hand", {}};
    if (motors_N < 1e9) slice.title += fmt::format(", motors of {} N", motors_N);
    for (const char* hand : {"none", "light"}) {
        for (const std::string& method : compared) {
            for (const double delay : {0.0, 0.5, 1.0, 2.0}) {
                for (const double period_s : {4e-3, 2e-3, 1e-3, 5e-4, 2.5e-4}) {
                    Cell cell = cell_of(method, hand);
                    cell.loop.period_s = period_s;
                    cell.loop.delay_s = delay * period_s;
                    cell.loop.motors_N = motors_N;
                    slice.cells.push_back(cell);
                }
            }
        }
    }
    return slice;
}

Slice damping() {
    Slice slice{"damping", "stiffness limit against virtual damping, by velocity filter", {}};
    for (const char* method : {"spring + difference", "spring + LP100", "spring + FOAW16"}) {
        for (const double period_s : {2e-3, 1e-3}) {
            for (const double delay : {0.0, 1.0}) {
                for (const double B :
                     {0.0, 0.2, 0.5, 1.0, 1.5, 2.0, 3.0, 5.0, 8.0, 10.0, 15.0, 20.0, 30.0}) {
                    Cell cell = cell_of(method, "none");
                    cell.loop.period_s = period_s;
                    cell.loop.delay_s = delay * period_s;
                    cell.damping_Ns_per_m = B;
                    slice.cells.push_back(cell);
                }
            }
        }
    }
    return slice;
}

Slice encoder_and_friction() {
    Slice slice{"encoder", "stiffness limit against encoder step, by Coulomb friction", {}};
    for (const char* method : {"spring", "spring + FOAW16"}) {
        for (const double coulomb_N : {0.0, 0.02, 0.05, 0.15}) {
            for (const double step_um : {0.0, 5.0, 10.0, 20.0, 41.0, 70.0, 102.0, 150.0}) {
                Cell cell = cell_of(method, "light");
                cell.loop.encoder_step_m = 1e-6 * step_um;
                cell.loop.tip.coulomb_N = coulomb_N;
                slice.cells.push_back(cell);
            }
        }
    }
    return slice;
}

Slice hands() {
    Slice slice{"hands", "stiffness limit by hand and delay", {}};
    for (const char* method : {"spring", "spring + FOAW16"}) {
        for (const char* hand : {"none", "light", "normal", "relaxed arm", "stiff arm",
                                 "light + skin", "light + bad skin", "normal + skin",
                                 "normal + bad skin", "arm + fair skin", "arm + bad skin"}) {
            for (const double delay : {0.0, 0.5, 1.0, 2.0}) {
                Cell cell = cell_of(method, hand);
                cell.loop.delay_s = delay * cell.loop.period_s;
                slice.cells.push_back(cell);
            }
        }
    }
    return slice;
}

Slice knock_speed() {
    Slice slice{"knock", "stiffness limit against speed of a knock, by friction and delay", {}};
    for (const double delay : {0.0, 1.0}) {
        for (const double coulomb_N : {0.02, 0.05, 0.15}) {
            for (const double speed : {0.05, 0.07, 0.1, 0.14, 0.2, 0.28, 0.4, 0.56, 0.8}) {
                Cell cell = cell_of("spring", "none");
                cell.loop.encoder_step_m = 0.0;
                cell.loop.delay_s = delay * cell.loop.period_s;
                cell.loop.tip.coulomb_N = coulomb_N;
                cell.knock_m_per_s = speed;
                slice.cells.push_back(cell);
            }
        }
    }
    return slice;
}

std::string number(double value) {
    if (std::abs(value) < 1e-9) return "0";  // rounding of a force at rest
    return value < 1e300 ? fmt::format("{:.5g}", value) : std::string("inf");
}

}  // namespace

const HandModel& hand_by_name(const std::string& name) {
    static const std::map<std::string, HandModel> hands = {
        {"none", no_hand},
        {"light", light_hand},
        {"normal", normal_hand},
        {"relaxed arm", relaxed_arm},
        {"stiff arm", stiff_arm},
        {"light + skin", light_skin},
        {"light + bad skin", light_bad_skin},
        {"normal + skin", normal_skin},
        {"normal + bad skin", normal_bad_skin},
        {"arm + fair skin", arm_fair_skin},
        {"arm + bad skin", arm_bad_skin},
    };
    return hands.at(name);
}

bool comes_to_rest(const Cell& cell, double stiffness_N_per_m) {
    const auto all = excitations_of(cell, stiffness_N_per_m);
    return std::all_of(all.begin(), all.end(), [&](const Excitation& excitation) {
        return is_calm(cell, render(cell, stiffness_N_per_m, excitation));
    });
}

Limits limits_of(const Cell& cell) {
    const WallLoop loop = force_loop(method(cell.method), cell.loop);
    const double b = damping_counted(loop);
    const double B = cell.damping_Ns_per_m;
    Limits limits;
    limits.linear = linear_stiffness(b, B, loop.period_s, loop.delay_s);
    limits.passive = passive(cell, loop);
    limits.quantiser = quantiser_stiffness(loop.tip.coulomb_N, loop.encoder_step_m);
    SampledWall wall{loop.period_s, loop.delay_s, B};
    if (cell.method == "spring + LP100") wall.cutoff_Hz = cutoff_Hz;
    limits.exact = LinearLoop(loop.tip, loop.hand, wall).largest_stiffness();
    limits.calmed = calmed_stiffness(cell.knock_m_per_s.value_or(0.1), b + B, loop.tip.coulomb_N,
                                     loop.period_s, loop.delay_s);
    return limits;
}

CellResult measure(const Cell& cell) {
    CellResult result;
    result.limits = limits_of(cell);
    result.stiffness_N_per_m =
        bisected_stiffness({}, [&](double stiffness) { return comes_to_rest(cell, stiffness); });
    for (const Excitation& excitation : excitations_of(cell, result.stiffness_N_per_m)) {
        const WallTrace trace = render(cell, result.stiffness_N_per_m, excitation);
        result.step_N = std::max(result.step_N, largest_step_N(trace));
        result.ripple_N = std::max(result.ripple_N, ripple_N(trace));
    }
    const double claimed = std::min(result.limits.passive, result.limits.quantiser);
    for (const double share : {0.1, 0.3, 0.5, 0.7, 0.85, 0.95}) {
        if (claimed > 1.0 && !comes_to_rest(cell, share * claimed)) ++result.unstable_below;
    }
    return result;
}

std::vector<Slice> slices() {
    return {period_and_delay("period", std::numeric_limits<double>::infinity()),
            period_and_delay("saturated", 5.0),
            damping(),
            encoder_and_friction(),
            hands(),
            knock_speed()};
}

std::string csv_line(const Cell& cell, const CellResult& result) {
    std::string line = cell.method + ',' + cell.hand;
    const WallLoop& loop = cell.loop;
    const Limits& limits = result.limits;
    for (const double value :
         {loop.motors_N, 1e3 * loop.period_s, loop.delay_s / loop.period_s, cell.damping_Ns_per_m,
          1e6 * loop.encoder_step_m, loop.tip.coulomb_N, cell.knock_m_per_s.value_or(0.0),
          result.stiffness_N_per_m, result.step_N, result.ripple_N, limits.linear, limits.passive,
          limits.quantiser, limits.exact, limits.calmed}) {
        line += ',' + number(value);
    }
    return line + fmt::format(",{}", result.unstable_below);
}

std::vector<CellResult> measure_all(const std::vector<Cell>& cells) {
    std::vector<CellResult> results(cells.size());
    for_each_index(cells.size(), [&](std::size_t i) { results[i] = measure(cells[i]); });
    return results;
}

std::uint64_t hashed(std::string_view text, std::uint64_t hash) {
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    return hash;
}

}  // namespace touchline::stability
