// How many wrong PINs there were, on the disk: a restart gives no try for nothing.
// Threads: any, each call by itself; they wait for the disk.
#pragma once

#include "config/types/result.h"

#include <filesystem>

namespace touchline {

/// operator.tries beside the PIN.
[[nodiscard]] std::filesystem::path pin_tries_file(const std::filesystem::path& pin);

/// Before a PIN is judged, with that one counted; on the disk when the call returns.
[[nodiscard]] Result<void> keep_pin_tries(const std::filesystem::path& file, int wrong);

/// 0 where there is no file: nothing was tried. One that is damaged, or open to others, fails:
/// count it as most_wrong_pins.
[[nodiscard]] Result<int> read_pin_tries(const std::filesystem::path& file);

}  // namespace touchline
