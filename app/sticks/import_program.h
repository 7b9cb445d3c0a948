// The program touchline-import, without its main(): one list or one file of one stick, then the
// end. Threads: one.
#pragma once

#include "app/sticks/refusal.h"

#include <cstddef>
#include <string>
#include <vector>

namespace touchline {

/// The descriptor that the answer is written to.
inline constexpr int import_output = 3;

/// No listing is larger.
inline constexpr std::size_t most_listing_bytes = std::size_t{2} << 20U;

/// Exit statuses: 0 all was written; 2 wrong words; first_refusal_status + StickRefusal.
inline constexpr int first_refusal_status = 80;

/// `list ROOT` or `read ROOT FOLDER NAME MOST_BYTES`. Shuts itself in, reads, writes the listing
/// (listing.h) or the file's bytes to import_output. Returns the exit status; the process must end
/// with it at once.
[[nodiscard]] int run_import(const std::vector<std::string>& words);

}  // namespace touchline
