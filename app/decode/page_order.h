// Which page of a document is wanted, and which worker may open it.
// Threads: values and pure functions.
#pragma once

#include "app/sandbox/limits.h"
#include "config/types/result.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace touchline {

struct PageOrder {
    int page = 1;   // 1 ... max_pages
    int dpi = 150;  // for documents without pixels of their own, 30 ... 600
};

/// Decides by the first bytes. Drawn files (SVG, PDF) need more libraries than pixels do; files of
/// a video codec (HEIC, AVIF) need others, and threads.
[[nodiscard]] WorkerKind kind_of(std::span<const std::byte> bytes);

/// The program that opens files of a kind.
[[nodiscard]] std::string program_for(WorkerKind kind);

/// What a worker gets on its command line; work_in() reads the same back.
struct DecodeWork {
    WorkerKind kind = WorkerKind::raster;
    PageOrder order;
};

[[nodiscard]] std::vector<std::string> arguments_of(const DecodeWork& work);
[[nodiscard]] Result<DecodeWork> work_in(std::span<const std::string> arguments);

}  // namespace touchline
