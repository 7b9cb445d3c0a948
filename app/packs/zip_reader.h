// Reads the files of a zip file; runs in the worker. Threads: one.
#pragma once

#include "app/packs/pack.h"

namespace touchline {

/// All or nothing. Fails as zip_members() does, and for a member that holds more than it claims,
/// has a wrong checksum, is a packed file itself, or is of a kind that no pack holds.
[[nodiscard]] PackResult<std::vector<PackFile>> files_in_zip(std::span<const std::byte> zip);

}  // namespace touchline
