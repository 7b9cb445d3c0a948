// touchline feel --replay: runs a recording of the kiosk's black box again.
// Threads: one.
#pragma once

#include "config/types/result.h"

#include <string>

namespace touchline {

struct ReplayOptions {
    std::string recording;
    std::string output;  // RUN.csv
};

/// Writes RUN.csv whole or not at all: the ticks of this run or, if a visitor's picture was felt,
/// the recorded ones. One sentence says which. Fails, after writing the table, if the run differs
/// from the recording in any bit.
[[nodiscard]] Result<std::string> run_replay(const ReplayOptions& options);

}  // namespace touchline
