// touchline feel --replay: a recording of the kiosk's black box, run again.
// Threads: one.
#pragma once

#include "config/types/result.h"

#include <string>

namespace touchline {

struct ReplayOptions {
    std::string recording;
    std::string output;  // RUN.csv
};

/// Writes RUN.csv whole or not at all: the ticks as they came out now, or, where a visitor's
/// picture was felt, as they were recorded. One sentence says which. Fails, with the table written,
/// where the run is not what was recorded, bit for bit.
[[nodiscard]] Result<std::string> run_replay(const ReplayOptions& options);

}  // namespace touchline
