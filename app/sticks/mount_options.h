// Which file systems are mounted, and how: strictly read-only.
// Threads: pure functions.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace touchline {

/// usual: FAT and exFAT. more: also ext4 and NTFS, which only the operator allows, because their
/// parsers are large and rarely tried with hostile sticks.
enum class FileSystems : std::uint8_t { usual, more };

/// The options for udisks2 and mount(8), by a file system's kernel name; nothing if it is not
/// mounted.
[[nodiscard]] std::optional<std::string> mount_options(std::string_view file_system,
                                                       FileSystems allowed);

}  // namespace touchline
