#include "app/sticks/mount_options.h"

namespace touchline {

std::optional<std::string> mount_options(std::string_view file_system, FileSystems allowed) {
    const std::string plain = "ro,nosuid,nodev,noexec,nosymfollow";
    if (file_system == "vfat" || file_system == "exfat") return plain;
    if (allowed == FileSystems::usual) return std::nullopt;
    // Read-only alone would still replay the journal, and so write.
    if (file_system == "ext4") return plain + ",noload";
    if (file_system == "ntfs") return plain + ",norecover";
    return std::nullopt;
}

}  // namespace touchline
