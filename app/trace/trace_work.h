// The work of touchline-trace, on its command line.
// Threads: values and pure functions.
#pragma once

#include "app/trace/photo_cut.h"
#include "config/types/result.h"
#include "vision/simplify/trace.h"

#include <span>
#include <string>
#include <vector>

namespace touchline {

/// photo: turns a camera's frame into a page. lines: finds a page's lines and makes a first map of
/// them. map: makes a map of lines that were found before.
enum class TraceStep : std::uint8_t { photo, lines, map };

struct TraceWork {
    TraceStep step = TraceStep::lines;
    TraceOptions options;
    bool wants_edges = false;      // also the picture of the edges' strengths
    bool has_main_things = false;  // a mask comes before the page (joined.h)
    PhotoCut cut;
};

[[nodiscard]] std::vector<std::string> arguments_of(const TraceWork& work);

/// Reads the same back, bit for bit. Fails for anything else. The ranges of the numbers are checked
/// where they are used.
[[nodiscard]] Result<TraceWork> trace_work_in(std::span<const std::string> arguments);

}  // namespace touchline
