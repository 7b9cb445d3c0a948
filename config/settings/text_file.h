// Files of settings as text. Threads: pure functions but for the reading of the file.
#pragma once

#include "config/types/result.h"

#include <cstddef>
#include <filesystem>
#include <string>

namespace touchline {

/// No file of settings is larger: 1 MB.
inline constexpr std::size_t largest_settings_bytes = std::size_t{1} << 20U;

/// All of the file; one line for one that cannot be read or is larger than that. Reads no more.
[[nodiscard]] Result<std::string> read_settings_file(const std::filesystem::path& file);

}  // namespace touchline
