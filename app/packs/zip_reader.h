// The files of a zip file, in the worker. Threads: one.
#pragma once

#include "app/packs/pack.h"

namespace touchline {

/// All or nothing. Fails as zip_members() does; for a member that holds more than it claims, whose
/// sum is wrong, that is a packed file itself or of a kind that no pack holds.
[[nodiscard]] PackResult<std::vector<PackFile>> files_in_zip(std::span<const std::byte> zip);

}  // namespace touchline
