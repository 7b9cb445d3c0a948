// The whole of the programs that trace: started by the kiosk for one step of one picture.
// Threads: the only one of its process.
#pragma once

#include "app/sandbox/limits.h"
#include "config/types/result.h"
#include "vision/contour/photo_lines.h"

#include <cstddef>
#include <span>

namespace touchline {

/// What a program is handed, apart: the network where it has one, and what the step works on.
struct TraceInput {
    Boundaries boundaries = {};
    std::span<const std::byte> work;
};

struct Tracer {
    WorkerKind kind = WorkerKind::trace;
    Result<TraceInput> (*input)(std::span<const std::byte> bytes) = nullptr;
};

/// main() of a program that traces. Does not return.
[[noreturn]] void run_trace_program(const Tracer& tracer, int argc, char** argv);

}  // namespace touchline
