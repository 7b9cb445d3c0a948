// A worker as its parent runs it: bytes in, bytes out, an end within its deadline.
// Threads: any, each call by itself; it waits for the worker, which dies with the calling thread.
#pragma once

#include "app/process/descriptor.h"
#include "app/process/memory.h"
#include "app/sandbox/limits.h"
#include "config/types/result.h"

#include <cstdint>
#include <string>
#include <vector>

namespace touchline {

struct WorkerOrder {
    std::string program;
    std::vector<std::string> arguments;
    WorkerKind kind = WorkerKind::raster;
};

/// Why there is no answer.
enum class WorkerEnd : std::uint8_t {
    not_started,  // the program is missing, or it could not shut itself in
    crashed,      // or tried what it may not
    out_of_time,  // of the processor or on the wall
    out_of_memory,
    no_answer,  // it ended well and wrote nothing
};

/// What is said of each end.
template <class Said>
struct SaidOfEnds {
    Said not_started;
    Said out_of_time;
    Said out_of_memory;
    Said unsafe;  // of the others

    [[nodiscard]] const Said& operator[](WorkerEnd end) const {
        if (end == WorkerEnd::not_started) return not_started;
        if (end == WorkerEnd::out_of_time) return out_of_time;
        return end == WorkerEnd::out_of_memory ? out_of_memory : unsafe;
    }
};

/// Exit statuses of a worker.
inline constexpr int worker_refused_to_start = 69;
inline constexpr int worker_out_of_memory = 70;

/// Runs it on `input` and gives what it wrote, sealed, at least one byte. Nothing else of this
/// process is within its reach.
[[nodiscard]] Result<Descriptor, WorkerEnd> run_worker(const WorkerOrder& order,
                                                       const Descriptor& input);

/// The same, as bytes.
[[nodiscard]] Result<Mapping, WorkerEnd> call_worker(const WorkerOrder& order,
                                                     const Descriptor& input);

}  // namespace touchline
