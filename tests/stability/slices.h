// The maps: two-dimensional slices through the space of period, delay, damping, encoder step,
// friction, hand and speed, one stiffness limit a cell.
// Threads: pure functions; measure_all() uses all processors, with the same result.
#pragma once

#include "tests/stability/cell.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace touchline::stability {

struct Slice {
    std::string name;   // of its file
    std::string title;  // in words
    std::vector<Cell> cells;
};

[[nodiscard]] std::vector<Slice> slices();

/// Of CSV lines.
inline constexpr std::string_view cell_columns =
    "method,hand,motors_N,period_ms,delay_periods,damping_Ns_per_m,encoder_um,coulomb_N,knock_m_"
    "per_s,"
    "limit_N_per_m,step_N,ripple_N,linear_N_per_m,passive_N_per_m,quantiser_N_per_m,exact_N_per_m,"
    "calmed_N_per_m,unstable_below";

/// Numbers with five digits: what differs beyond them need not be the same on every machine.
[[nodiscard]] std::string csv_line(const Cell& cell, const CellResult& result);

/// Of all cells, in order.
[[nodiscard]] std::vector<CellResult> measure_all(const std::vector<Cell>& cells);

/// Fowler, Noll and Vo, 64 bits; start from `hash`.
[[nodiscard]] std::uint64_t hashed(std::string_view text, std::uint64_t hash = 0xcbf29ce484222325U);

}  // namespace touchline::stability
