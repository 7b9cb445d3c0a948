// A network from its publisher to where Touchline looks for it. Threads: any, one call at a time.
#pragma once

#include "app/models/networks.h"
#include "config/types/result.h"

#include <filesystem>

namespace touchline {

/// Takes the publisher's package by its checksum, rewrites it and puts it into models_folder(): the
/// file is there whole or not at all. Needs the network of the computer, npm and Python. Fails with
/// one line. Who calls it has shown the licence.
[[nodiscard]] Result<void> get_network(const Network& network);

/// The file of a network that somebody brought, if it is what the table says: the same by a stick.
[[nodiscard]] Result<void> take_network(const Network& network, const std::filesystem::path& file);

}  // namespace touchline
