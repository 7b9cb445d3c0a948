// Runs a worker for its parent: bytes in, bytes out, and an end within its deadline.
// Threads: any, each call by itself; it waits for the worker, which dies with the calling thread.
#pragma once

#include "app/isolation/process/descriptor.h"
#include "app/isolation/process/memory.h"
#include "app/isolation/sandbox/limits.h"
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
    not_started,    // the program is missing, or its sandbox failed
    crashed,        // or tried something forbidden
    out_of_time,    // processor time or wall clock
    out_of_memory,  // its own limit, or the machine's memory
    no_answer,      // it ended normally and wrote nothing
};

/// The message for each end.
template <class Said>
struct SaidOfEnds {
    Said not_started;
    Said out_of_time;
    Said out_of_memory;
    Said unsafe;  // for all other ends

    [[nodiscard]] const Said& operator[](WorkerEnd end) const {
        if (end == WorkerEnd::not_started) return not_started;
        if (end == WorkerEnd::out_of_time) return out_of_time;
        return end == WorkerEnd::out_of_memory ? out_of_memory : unsafe;
    }
};

/// Exit statuses of a worker.
inline constexpr int worker_refused_to_start = 69;
inline constexpr int worker_out_of_memory = 70;

/// Runs it on `input` and returns what it wrote, sealed, at least one byte. The worker can reach
/// nothing else of this process.
[[nodiscard]] Result<Descriptor, WorkerEnd> run_worker(const WorkerOrder& order,
                                                       const Descriptor& input);

/// The same, as bytes.
[[nodiscard]] Result<Mapping, WorkerEnd> call_worker(const WorkerOrder& order,
                                                     const Descriptor& input);

}  // namespace touchline
