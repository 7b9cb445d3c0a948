// The list at the end of a zip file, read before anything is unpacked. Gives a sound list of plain
// names, or what is wrong. Threads: pure functions.
#pragma once

#include "app/packs/pack_finding.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace touchline {

struct ZipMember {
    std::string name;
    std::uint32_t bytes = 0;  // unpacked, by the file's own claim
};

/// The files in the order of the list; leaves out folders and litter (plain_names.h). Refuses a
/// file that is no zip file or has more than one disk, locked members, links, devices, names that
/// are not plain or occur twice, and sizes and counts beyond pack_limits. The bytes may be
/// anything. O(bytes).
[[nodiscard]] PackResult<std::vector<ZipMember>> zip_members(std::span<const std::byte> zip);

}  // namespace touchline
