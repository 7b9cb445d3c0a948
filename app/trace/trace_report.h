// What a trace chose, found and left out, as JSON.
// Threads: pure function.
#pragma once

#include "vision/simplify/trace.h"

#include <string>

namespace touchline {

/// An object of flat values, in lines of text. O(outlines).
[[nodiscard]] std::string report_json(const TactileMap& map, const TraceReport& report);

}  // namespace touchline
