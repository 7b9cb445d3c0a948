// Reads settings files as text. Threads: pure functions, except for reading the file.
#pragma once

#include "config/types/result.h"

#include <cstddef>
#include <filesystem>
#include <string>

namespace touchline {

/// The largest size of a settings file: 1 MB.
inline constexpr std::size_t largest_settings_bytes = std::size_t{1} << 20U;

/// Reads the whole file. A file that cannot be read, or is larger than that, gives a one-line
/// error. Reads no more.
[[nodiscard]] Result<std::string> read_settings_file(const std::filesystem::path& file);

}  // namespace touchline
