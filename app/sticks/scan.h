// The files of a stick: of its root and of its folders, down to deepest_folder. Memory does not
// grow with the stick: only the names that may be listed are kept. Threads: any, each call by
// itself; a call waits for the stick.
#pragma once

#include "app/process/descriptor.h"
#include "app/sticks/listing.h"
#include "app/sticks/natural_order.h"
#include "app/sticks/refusal.h"

#include <cstddef>
#include <cstdint>
#include <functional>

namespace touchline {

/// pictures: what visitors are offered, in the root and all folders. operator_files: what
/// the operator is offered, in the root alone.
enum class StickSearch : std::uint8_t { pictures, operator_files };

/// What a scan may take; beyond, the listing says that it was cut short.
struct ScanLimits {
    /// The first in natural order, folder by folder; at most most_listed_folders.
    std::size_t most_folders = most_listed_folders;
    std::size_t most_names = 200'000;  // of all folders together, also of what is not listed
    std::function<bool()> is_time_up = [] { return false; };  // asked every few hundred names
};

/// Regular files of known endings; links, FIFOs, sockets, devices, hidden files and what systems
/// leave behind are passed over. A folder that cannot be read is passed over too, and the listing
/// says so. Fails only where the root itself cannot be read, with errno's words. O(n log k)
/// for n names and k listed.
[[nodiscard]] Result<StickListing, StickRefusal> scan_stick(const Descriptor& root,
                                                            const NaturalOrder& order,
                                                            const ScanLimits& limits,
                                                            StickSearch search);

}  // namespace touchline
