// The file systems that are mounted, and how: read-only to the last byte.
// Threads: pure functions.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace touchline {

/// usual: FAT and exFAT. more: ext4 and NTFS too, which only the operator allows: what parses them
/// is large, and rarely tried with hostile sticks.
enum class FileSystems : std::uint8_t { usual, more };

/// For udisks2 and mount(8), of a file system by its kernel name; none for those that are not
/// mounted.
[[nodiscard]] std::optional<std::string> mount_options(std::string_view file_system,
                                                       FileSystems allowed);

}  // namespace touchline
