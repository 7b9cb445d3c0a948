// How many wrong PINs there were, on the disk, so that a restart gives no free try.
// Threads: any, each call by itself; they wait for the disk.
#pragma once

#include "config/types/result.h"

#include <filesystem>

namespace touchline {

/// operator.tries beside the PIN.
[[nodiscard]] std::filesystem::path pin_tries_file(const std::filesystem::path& pin);

/// Called before a PIN is judged, with that one counted. It is on the disk when the call returns.
[[nodiscard]] Result<void> keep_pin_tries(const std::filesystem::path& file, int wrong);

/// Returns 0 if there is no file: nothing was tried. Fails if the file is damaged or open to
/// others; count that as most_wrong_pins.
[[nodiscard]] Result<int> read_pin_tries(const std::filesystem::path& file);

}  // namespace touchline
