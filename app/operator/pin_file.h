// The operator's PIN on the disk: its yescrypt hash, in a file that only the kiosk reads.
// Threads: any, each call by itself; a hash takes some hundredths of a second.
#pragma once

#include "config/types/result.h"

#include <filesystem>
#include <string>

namespace touchline {

/// operator.pin beside the site's settings.
[[nodiscard]] std::filesystem::path pin_file();

/// True if a PIN is kept. A file that exists and cannot be read counts: nobody gets in by breaking
/// it.
[[nodiscard]] bool has_pin(const std::filesystem::path& file);

/// Stores a PIN of digits as in pin.h. The file has mode 0600 and appears whole or not at all.
[[nodiscard]] Result<void> keep_pin(const std::filesystem::path& file, const std::string& pin);

/// Takes as long for a wrong PIN as for the right one. Fails if the file is missing, is no hash, or
/// can be read or written by others.
[[nodiscard]] Result<bool> is_right_pin(const std::filesystem::path& file, const std::string& pin);

}  // namespace touchline
