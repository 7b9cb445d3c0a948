// The figures of simulations as lines for people, as a file to be gathered, and as rows of the
// reliability table. Threads: pure functions.
#pragma once

#include "config/types/result.h"
#include "tests/sim/kiosk/figures.h"

#include <string>
#include <string_view>

namespace touchline {

/// For people; ends with a newline.
[[nodiscard]] std::string lines_of(const SimFigures& figures);

/// A line a figure, "name value"; read_stored() gives them back, hashes and failure apart.
[[nodiscard]] std::string stored(const SimFigures& figures);

/// Fails for what stored() did not write.
[[nodiscard]] Result<SimFigures> read_stored(std::string_view text);

/// Rows 1 to 5 and 26 as CSV, `row,figure,value,bar,passed,how`, with its head. `command`: how they
/// were measured.
[[nodiscard]] std::string reliability_csv(const SimFigures& figures, const std::string& command);

}  // namespace touchline
