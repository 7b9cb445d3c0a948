// The list at the end of a zip file, read before anything is unpacked: a sound list of plain names,
// or what is wrong. Threads: pure functions.
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
    std::uint32_t bytes = 0;  // unpacked, as the file claims
};

/// Files only, in the order of the list; folders and litter (plain_names.h) are left out. Refused:
/// what is no zip file or has more than one disk, locked members, links, devices, names that are
/// not plain or there twice, sizes and counts beyond pack_limits. Any bytes may be given. O(bytes).
[[nodiscard]] PackResult<std::vector<ZipMember>> zip_members(std::span<const std::byte> zip);

}  // namespace touchline
