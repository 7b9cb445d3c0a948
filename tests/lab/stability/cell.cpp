#include "tests/lab/stability/cell.h"

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

std::vector<Excitation> excitations_of(const Cell& cell, double stiffness_N_per_m) {
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

}  // namespace touchline::stability
