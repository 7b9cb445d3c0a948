#include "tests/lab/stability/slices.h"

#include "tests/lab/stability/for_each_index.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/core.h>

namespace touchline::stability {
namespace {

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
