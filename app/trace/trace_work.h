// What touchline-trace is started for, as its command line tells it.
// Threads: values and pure functions.
#pragma once

#include "app/trace/photo_cut.h"
#include "config/types/result.h"
#include "vision/simplify/trace.h"

#include <span>
#include <string>
#include <vector>

namespace touchline {

/// photo: a camera's frame becomes a page. lines: a page's lines and a first map of them. map: a
/// map of lines that were found before.
enum class TraceStep : std::uint8_t { photo, lines, map };

struct TraceWork {
    TraceStep step = TraceStep::lines;
    TraceOptions options;
    bool wants_edges = false;      // the picture of the edges' strengths as well
    bool has_main_things = false;  // a mask comes before the page (joined.h)
    PhotoCut cut;
};

[[nodiscard]] std::vector<std::string> arguments_of(const TraceWork& work);

/// The same back, bit for bit. Fails for anything else; whether numbers are in their range is asked
/// where they are used.
[[nodiscard]] Result<TraceWork> trace_work_in(std::span<const std::string> arguments);

}  // namespace touchline
