// What the programs of the workers share: started by the kiosk for one piece of work, each shuts
// itself in, and only then reads the first byte.
#pragma once

#include "app/sandbox/limits.h"
#include "config/types/result.h"

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace touchline {

struct WorkerProgram {
    WorkerKind kind = WorkerKind::raster;
    /// Before it is shut in, where only the system's files can be read; may be empty.
    std::function<void()> prepare;
    /// From what it was handed to what it answers; a line is answered as a refusal.
    std::function<Result<std::vector<std::byte>>(std::span<const std::byte>)> work;
};

/// Does not return.
[[noreturn]] void run_worker_program(const WorkerProgram& program);

/// The end of a program that was not started by the kiosk.
[[noreturn]] void refuse_to_run(const char* program);

}  // namespace touchline
