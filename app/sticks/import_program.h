// The program touchline-import without its main(): reads one list or one file of one stick, then
// ends. Threads: one.
#pragma once

#include "app/process/descriptor.h"
#include "app/sticks/listing.h"
#include "config/types/result.h"

#include <cstddef>
#include <string>
#include <vector>

namespace touchline {

/// The descriptor for the answer.
inline constexpr int import_output = 3;

/// The largest listing: its names and paths, and some bytes for each.
inline constexpr std::size_t most_listing_bytes = std::size_t{9} << 20U;

/// Exit statuses: 0 everything was written; 2 wrong words; first_refusal_status + StickRefusal.
inline constexpr int first_refusal_status = 80;

/// Closes the sandbox before the first name is read. After that the process can read below `root`,
/// make its output grow to `most_bytes`, and nothing else (app/sandbox). If this fails, the process
/// must end at once.
[[nodiscard]] Result<void> shut_in(const Descriptor& root, std::size_t most_bytes);

/// `words`: `list ROOT`, `operator ROOT` or `read ROOT FOLDER NAME MOST_BYTES`. Closes the sandbox,
/// reads, and writes the listing (listing.h) or the file's bytes to import_output. Returns the exit
/// status; the process must end with it at once.
[[nodiscard]] int run_import(const std::vector<std::string>& words);

}  // namespace touchline
