// The operator's PIN on the disk: its yescrypt hash, and how many wrong ones there were, so that a
// restart gives no free try. Each is a small file that only the kiosk's user may read.
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

/// operator.tries beside the PIN.
[[nodiscard]] std::filesystem::path pin_tries_file(const std::filesystem::path& pin);

/// Called before a PIN is judged, with that one counted. It is on the disk when the call returns,
/// so pulling the plug undoes nothing.
[[nodiscard]] Result<void> keep_pin_tries(const std::filesystem::path& file, int wrong);

/// Returns 0 if there is no file: nothing was tried. Fails if the file is damaged or open to
/// others; count that as most_wrong_pins.
[[nodiscard]] Result<int> read_pin_tries(const std::filesystem::path& file);

}  // namespace touchline
