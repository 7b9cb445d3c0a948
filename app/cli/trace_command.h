// touchline trace: writes the outlines of a picture as a map.
// Threads: one.
#pragma once

#include "app/cli/load.h"
#include "config/types/result.h"
#include "vision/simplify/trace.h"

#include <string>

namespace touchline {

struct TraceCommandOptions {
    std::string input;   // a picture, whatever its name
    std::string output;  // MAP.svg
    std::string report;  // REPORT.json; empty: none
    std::string edges;   // STRENGTH.png; empty: none
    std::string figure;  // MASK.png; empty: none
    ViewChoice view;     // of the first page
    TraceOptions trace;
};

/// Writes the map and the other requested files, each whole or not at all. Returns one sentence
/// worth telling the user (outlines cut to the budget), else an empty text.
[[nodiscard]] Result<std::string> run_trace(const TraceCommandOptions& options);

}  // namespace touchline
