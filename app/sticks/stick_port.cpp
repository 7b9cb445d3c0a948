#include "app/sticks/stick_port.h"

#include "app/sticks/folder_port.h"
#include "app/sticks/udisks_port.h"

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

std::unique_ptr<StickPort> open_stick_port(const std::string& watched_folder) {
    if (!watched_folder.empty()) return std::make_unique<FolderPort>(watched_folder);
    return std::make_unique<UdisksPort>();
}

}  // namespace touchline
