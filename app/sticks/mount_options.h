// The file systems that are mounted, and how: read-only to the last byte.
// Threads: pure functions.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace touchline {

/// For udisks2 and mount(8), of a file system by its kernel name; none for those that are not
/// mounted: what parses them is too rarely used to be trusted with a stranger's bytes.
[[nodiscard]] std::optional<std::string> mount_options(std::string_view file_system);

}  // namespace touchline
