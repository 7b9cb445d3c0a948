// What touchline-import shuts itself in with before it reads the first name: it can read below the
// stick's root, write what it was handed, and nothing else.
// Threads: the only one of its process.
#pragma once

#include "app/process/descriptor.h"
#include "config/types/result.h"

#include <cstddef>

namespace touchline {

/// Dies with its parent, cannot be traced, limits of memory, processor time and output
/// (`most_bytes`), Landlock with the rights of ABI 2 (read beneath `root`), then the list of
/// allowed calls. Not to be undone. On failure the process must end at once; the line says which
/// step failed.
[[nodiscard]] Result<void> shut_in(const Descriptor& root, std::size_t most_bytes);

}  // namespace touchline
