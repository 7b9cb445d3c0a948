// A small file that only the kiosk's user may read: the operator's PIN, and what wrong ones cost.
// Threads: any, each call by itself; they wait for the disk.
#pragma once

#include "config/types/result.h"

#include <cstddef>
#include <filesystem>
#include <string>

namespace touchline {

/// Mode 0600, whole or not at all, and on the disk when the call returns: pulling the plug then
/// takes nothing back.
[[nodiscard]] Result<void> write_private(const std::filesystem::path& file,
                                         const std::string& text);

/// Reads at most so many bytes of it. Fails where it is missing, no file, or open to others.
[[nodiscard]] Result<std::string> read_private(const std::filesystem::path& file,
                                               std::size_t most_bytes);

/// Is anything there? What cannot be looked at counts, a link to nothing too.
[[nodiscard]] bool is_private_there(const std::filesystem::path& file);

/// The file is gone for good when the call returns. One that is not there is removed already.
[[nodiscard]] Result<void> remove_private(const std::filesystem::path& file);

}  // namespace touchline
