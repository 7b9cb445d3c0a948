// The only place of app/documents/decode that touches the file system: whole files in, whole files
// out. Threads: any; two writers of the same path leave one of the two files, whole.
#pragma once

#include "config/types/result.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace touchline {

/// No picture and no map is larger. This limit also stops at a device file or a pipe that never
/// ends.
constexpr std::size_t max_file_bytes = std::size_t{256} << 20U;

/// Reads all bytes of a file. Fails with "PATH: ..." if it cannot be opened or read, is a folder or
/// is larger than max_file_bytes. O(size).
[[nodiscard]] Result<std::vector<std::byte>> read_file(const std::string& path);

/// The same as text.
[[nodiscard]] Result<std::string> read_text(const std::string& path);

/// Writes the file whole or not at all: writes a temporary file beside it, flushes it to the disk,
/// then renames it over the file. If that fails, the old file, if any, stays as it was. Follows a
/// link. Writes straight to anything that is no regular file (/dev/stdout, a pipe). O(size).
[[nodiscard]] Result<void> write_whole_file(const std::string& path,
                                            std::span<const std::byte> bytes);
[[nodiscard]] Result<void> write_whole_file(const std::string& path, const std::string& text);

/// The names in a folder survive a power cut only if the folder is flushed too. True if it was:
/// some file systems refuse it, and the files are whole either way.
bool flush_folder(const std::filesystem::path& folder);

/// True if anything is there, also a link to nothing. Counts what cannot be examined: whoever took
/// it for missing would go on without it, or put something in its place.
[[nodiscard]] bool is_there(const std::filesystem::path& path);

}  // namespace touchline
