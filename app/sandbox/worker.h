// A worker as its parent runs it: bytes in, bytes out, an end within its deadline.
// Threads: any, each call by itself; it waits for the worker, which dies with the calling thread.
#pragma once

#include "app/process/descriptor.h"
#include "app/sandbox/limits.h"

#include <cstdint>
#include <string>
#include <vector>

namespace touchline {

struct WorkerOrder {
    std::string program;
    std::vector<std::string> arguments;
    WorkerKind kind = WorkerKind::raster;
};

enum class WorkerEnd : std::uint8_t {
    done,         // it says so; what it wrote is sealed
    not_started,  // the program is missing, or it could not shut itself in
    crashed,      // or tried what it may not
    out_of_time,  // of the processor or on the wall
    out_of_memory,
    no_answer,  // it ended well and wrote nothing
};

struct WorkerOutcome {
    WorkerEnd end = WorkerEnd::not_started;
    Descriptor output;  // of a worker that is done, sealed, at least one byte
};

/// Exit statuses of a worker.
inline constexpr int worker_refused_to_start = 69;
inline constexpr int worker_out_of_memory = 70;

/// Runs it on `input`. Nothing else of this process is within its reach.
[[nodiscard]] WorkerOutcome run_worker(const WorkerOrder& order, const Descriptor& input);

}  // namespace touchline
