// The only place of app/decode that touches the file system: whole files in, whole files out.
// Threads: any; two writers of the same path leave one of the two files, whole.
#pragma once

#include "config/types/result.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace touchline {

/// No picture and no map is larger; a device file or a pipe that never ends stops here as well.
constexpr std::size_t max_file_bytes = std::size_t{256} << 20U;

/// All bytes of a file. Fails with "PATH: ..." when it cannot be opened or read, is a folder or is
/// larger than max_file_bytes. O(size).
[[nodiscard]] Result<std::vector<std::byte>> read_file(const std::string& path);

/// Writes the file whole or not at all: into a temporary beside it, flushed to the disk, then
/// renamed over it. On failure the old file, if any, is as it was. A link is followed; what exists
/// and is no regular file (/dev/stdout, a pipe) is written straight. O(size).
[[nodiscard]] Result<void> write_whole_file(const std::string& path,
                                            std::span<const std::byte> bytes);
[[nodiscard]] Result<void> write_whole_file(const std::string& path, const std::string& text);

}  // namespace touchline
