// What the workers' programs share. The kiosk starts each for one piece of work; it closes its
// sandbox, and only then reads the first byte.
#pragma once

#include "app/decode/file_format.h"
#include "app/decode/page.h"
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
    /// Runs before the sandbox closes, while only the system's files can be read; may be empty.
    std::function<void()> prepare;
    /// Turns its input into its answer. An error line becomes a refusal.
    std::function<Result<std::vector<std::byte>>(std::span<const std::byte>)> work;
};

/// Does not return.
[[noreturn]] void run_worker_program(const WorkerProgram& program);

/// Ends a program that the kiosk did not start.
[[noreturn]] void refuse_to_run(const char* program);

struct Decoder {
    void (*prepare)() = nullptr;  // runs before the sandbox closes, reads only the system's files
    Result<Page> (*decode)(std::span<const std::byte> bytes, const PageOrder& order) = nullptr;
};

/// The main() of a decoder. Does not return.
[[noreturn]] void run_decode_program(const Decoder& decoder, int argc, char** argv);

}  // namespace touchline
