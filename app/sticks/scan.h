// Finds the files of a stick, in its root and its folders, down to deepest_folder. Memory does not
// grow with the stick: it keeps only names that may be listed. Threads: any, each call by itself; a
// call waits for the stick.
#pragma once

#include "app/process/descriptor.h"
#include "app/sticks/listing.h"
#include "app/sticks/names.h"

#include <cstddef>
#include <cstdint>
#include <functional>

namespace touchline {

/// pictures: what visitors are offered, in the root and all folders. operator_files: what the
/// operator is offered, only in the root.
enum class StickSearch : std::uint8_t { pictures, operator_files };

/// The limits of a scan. If it exceeds one, the listing says that it was cut short.
struct ScanLimits {
    /// The first folders in natural order, one by one; at most most_listed_folders.
    std::size_t most_folders = most_listed_folders;
    std::size_t most_names = 200'000;  // in all folders together, listed or not
    std::function<bool()> is_time_up = [] { return false; };  // called every few hundred names
};

/// Finds regular files of known endings. Skips links, FIFOs, sockets, devices, hidden files and
/// what systems leave behind. Also skips a folder that cannot be read, and the listing says so.
/// Fails only if the root itself cannot be read, with errno's words. O(n log k) for n names and k
/// listed.
[[nodiscard]] Result<StickListing, StickRefusal> scan_stick(const Descriptor& root,
                                                            const NaturalOrder& order,
                                                            const ScanLimits& limits,
                                                            StickSearch search);

}  // namespace touchline
