// The figures of simulations as lines for people, as a file for gathering, and as rows of the
// reliability table. Threads: pure functions.
#pragma once

#include "config/types/result.h"
#include "tests/machines/sim/kiosk/figures.h"

#include <string>
#include <string_view>

namespace touchline {

/// Returns lines for people; they end with a newline.
[[nodiscard]] std::string lines_of(const SimFigures& figures);

/// Returns a line "name value" for each figure; read_stored() reads them back, without hashes and
/// failure.
[[nodiscard]] std::string stored(const SimFigures& figures);

/// Fails for text that stored() did not write.
[[nodiscard]] Result<SimFigures> read_stored(std::string_view text);

/// Returns rows 1 to 5 and 26 as CSV, `row,figure,value,bar,passed,how`, with the header.
/// `command`: how they were measured.
[[nodiscard]] std::string reliability_csv(const SimFigures& figures, const std::string& command);

}  // namespace touchline
