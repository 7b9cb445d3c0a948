// A small file that only the kiosk's user may read: the operator's PIN, and the cost of wrong ones.
// Threads: any, each call by itself; they wait for the disk.
#pragma once

#include "config/types/result.h"

#include <cstddef>
#include <filesystem>
#include <string>

namespace touchline {

/// Writes with mode 0600, whole or not at all. The file is on the disk when the call returns, so
/// pulling the plug undoes nothing.
[[nodiscard]] Result<void> write_private(const std::filesystem::path& file,
                                         const std::string& text);

/// Reads at most `most_bytes` bytes. Fails if it is missing, no file, or open to others.
[[nodiscard]] Result<std::string> read_private(const std::filesystem::path& file,
                                               std::size_t most_bytes);

/// True if anything is there. Counts what cannot be examined, and a link to nothing.
[[nodiscard]] bool is_private_there(const std::filesystem::path& file);

/// Removes the file for good before the call returns. Succeeds if it does not exist.
[[nodiscard]] Result<void> remove_private(const std::filesystem::path& file);

}  // namespace touchline
