// The maps: two-dimensional slices through the space of period, delay, damping, encoder step,
// friction, hand and speed, one stiffness limit per cell.
// Threads: pure functions; measure_all() uses all processors, with the same result.
#pragma once

#include "tests/lab/stability/cell.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace touchline::stability {

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
