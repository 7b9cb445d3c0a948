#include "app/documents/sticks/stick_port.h"

#include "app/isolation/process/descriptor.h"

#include <array>

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>

namespace touchline {
namespace {

constexpr std::int64_t look_every_ns = 500'000'000;

bool is_empty_folder(const Descriptor& folder) {
    alignas(dirent64) std::array<char, 4096> buffer{};
    for (;;) {
        const ssize_t got = ::getdents64(folder.number(), buffer.data(), buffer.size());
        if (got <= 0) return true;
        for (std::size_t at = 0; at < static_cast<std::size_t>(got);) {
            const auto& entry = *reinterpret_cast<const dirent64*>(buffer.data() + at);
            at += entry.d_reclen;
            const std::string_view name = entry.d_name;
            if (name != "." && name != "..") return false;
        }
    }
}

}  // namespace

std::optional<std::string> mount_options(std::string_view file_system, FileSystems allowed) {
    const std::string plain = "ro,nosuid,nodev,noexec,nosymfollow";
    if (file_system == "vfat" || file_system == "exfat") return plain;
    if (allowed == FileSystems::usual) return std::nullopt;
    // Read-only alone would still replay the journal, and so write.
    if (file_system == "ext4") return plain + ",noload";
    if (file_system == "ntfs") return plain + ",norecover";
    return std::nullopt;
}

std::vector<StickEvent> FolderPort::poll(std::int64_t now_ns) {
    if (now_ns < next_look_ns_) return {};
    next_look_ns_ = now_ns + look_every_ns;
    const auto now = look();
    if (now == last_) return {};
    std::vector<StickEvent> events;
    if (last_) events.push_back({StickNews::gone, folder_, ""});
    if (now) events.push_back({StickNews::ready, folder_, ""});
    last_ = now;
    return events;
}

std::optional<FolderPort::Look> FolderPort::look() {
    const Descriptor folder(
        ::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NONBLOCK));
    FileStatus status{};
    is_watching_ = folder.is_open() && ::fstat(folder.number(), &status) == 0;
    if (!is_watching_ || is_empty_folder(folder)) return std::nullopt;
    return Look{status.st_dev, status.st_ino, status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
}

}  // namespace touchline
