// The stability maps: two-dimensional slices through the space of period, delay, damping, encoder
// step, friction, hand and speed, one stiffness limit per cell.
// Threads: pure functions; measure_all() uses all processors, with the same result.
#pragma once

#include "tests/lab/stability/wall_controllers.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchline::stability {

/// One cell of a stability map: a method, a loop, a hand; its largest stiffness by simulation, and
/// what theory says of it.
struct Cell {
    std::string method = "spring";  // one of methods()
    std::string hand = "none";      // one of named_hands()
    WallLoop loop;                  // its hand is the named one
    double damping_Ns_per_m = 0.0;  // B, where the method damps
    /// Applies only a knock at this speed, to a tip pressed so hard that it stays in contact;
    /// without a value all of the excitations.
    std::optional<double> knock_m_per_s;
};

/// All in N/m; infinity if there is no limit.
struct Limits {
    double linear = 0.0;     // (b + B) / (T/2 + t_d), b with the worse damped of skin and hand
    double passive = 0.0;    // against any passive hand (a rigid one: this one)
    double quantiser = 0.0;  // 2 f_c / Delta
    double exact = 0.0;      // eigenvalues; for a wall that is not linear, of its spring and damper
    double calmed = 0.0;     // friction calms a knock of 0.1 m/s, or the cell's
};

struct CellResult {
    double stiffness_N_per_m = 0.0;  // largest below which all come to rest, within 1 %
    double step_N = 0.0;             // largest change of force in a period there
    double ripple_N = 0.0;           // rms of the force in the last fifth there
    Limits limits;
    int unstable_below = 0;  // of six stiffnesses below both the passive and the quantiser's limit
};

/// Applies the excitations: impacts at 0.02, 0.1 and 0.3 m/s pushed with 1 N; pressed from rest
/// with 3 N; a push of 2 N of which 1 N is let go. Comes to rest: in the last fifth of the run (2
/// s, or 60 swings where those last longer) the tip moves by less than 20 um or two encoder steps,
/// or the ringing is clearly on its way there.
[[nodiscard]] bool comes_to_rest(const Cell& cell, double stiffness_N_per_m);

[[nodiscard]] Limits limits_of(const Cell& cell);

/// Bisects a grid of stiffnesses, each 1 % above the one before; takes it that all below one that
/// comes to rest do so, too.
[[nodiscard]] CellResult measure(const Cell& cell);

[[nodiscard]] const HandModel& hand_by_name(const std::string& name);

struct Slice {
    std::string name;   // the file's
    std::string title;  // in words
    std::vector<Cell> cells;
};

[[nodiscard]] std::vector<Slice> slices();

/// The columns of the CSV lines.
inline constexpr std::string_view cell_columns =
    "method,hand,motors_N,period_ms,delay_periods,damping_Ns_per_m,encoder_um,coulomb_N,knock_m_"
    "per_s,"
    "limit_N_per_m,step_N,ripple_N,linear_N_per_m,passive_N_per_m,quantiser_N_per_m,exact_N_per_m,"
    "calmed_N_per_m,unstable_below";

/// Writes numbers with five digits, because digits beyond them may differ from machine to machine.
[[nodiscard]] std::string csv_line(const Cell& cell, const CellResult& result);

/// Measures all cells, in order.
[[nodiscard]] std::vector<CellResult> measure_all(const std::vector<Cell>& cells);

/// Returns the hash of Fowler, Noll and Vo, 64 bits; starts from `hash`.
[[nodiscard]] std::uint64_t hashed(std::string_view text, std::uint64_t hash = 0xcbf29ce484222325U);

}  // namespace touchline::stability
