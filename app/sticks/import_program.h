// The program touchline-import, without its main(): one list or one file of one stick, then the
// end. Threads: one.
#pragma once

#include "app/process/descriptor.h"
#include "app/sticks/refusal.h"
#include "config/types/result.h"

#include <cstddef>
#include <string>
#include <vector>

namespace touchline {

/// The descriptor that the answer is written to.
inline constexpr int import_output = 3;

/// No listing is larger: its names and paths, and some bytes for each.
inline constexpr std::size_t most_listing_bytes = std::size_t{9} << 20U;

/// Exit statuses: 0 all was written; 2 wrong words; first_refusal_status + StickRefusal.
inline constexpr int first_refusal_status = 80;

/// What it shuts itself in with before it reads the first name: it can read below `root`, make its
/// output grow to `most_bytes`, and nothing else (app/sandbox). On failure it must end at once.
[[nodiscard]] Result<void> shut_in(const Descriptor& root, std::size_t most_bytes);

/// `list ROOT`, `operator ROOT` or `read ROOT FOLDER NAME MOST_BYTES`. Shuts itself in, reads,
/// writes the listing (listing.h) or the file's bytes to import_output. Returns the exit status;
/// the process must end with it at once.
[[nodiscard]] int run_import(const std::vector<std::string>& words);

}  // namespace touchline
