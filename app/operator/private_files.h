// Small files that only the kiosk's user may read: the PIN, and the key of a house. Their mode is
// 0600, and what was written is on the disk when a call returns, so pulling the plug undoes
// nothing. Threads: any, each call by itself; calls wait for the disk.
#pragma once

#include "config/types/result.h"

#include <cstddef>
#include <filesystem>
#include <string>

namespace touchline {

/// Writes the file whole or not at all, and makes its folder.
[[nodiscard]] Result<void> write_private(const std::filesystem::path& file,
                                         const std::string& text);

/// Reads at most `limit` bytes. Fails if it is missing, no file, a link, or open to others.
[[nodiscard]] Result<std::string> read_private(const std::filesystem::path& file,
                                               std::size_t limit);

/// Removes the file for good before the call returns. Succeeds if it does not exist.
[[nodiscard]] Result<void> remove_private(const std::filesystem::path& file);

}  // namespace touchline
