#include "app/sticks/beneath.h"

#include <cerrno>
#include <vector>

#include <fcntl.h>
#include <linux/openat2.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace touchline {
namespace {

int openat2(int folder, const char* name, int flags) {
    open_how how{};
    how.flags = static_cast<unsigned>(flags);
    how.resolve = RESOLVE_BENEATH | RESOLVE_NO_SYMLINKS | RESOLVE_NO_MAGICLINKS | RESOLVE_NO_XDEV;
    return static_cast<int>(::syscall(SYS_openat2, folder, name, &how, sizeof(how)));
}

constexpr std::size_t block_bytes = std::size_t{256} << 10U;

using Refused = tl::unexpected<StickRefusal>;

Refused refused_by_system() {
    return Refused(refusal_of(errno));
}

/// The size of an open file that may be read.
Result<std::size_t, StickRefusal> size_of(const Descriptor& file, std::size_t most_bytes) {
    struct stat status {};

    if (::fstat(file.number(), &status) != 0) return refused_by_system();
    if (!S_ISREG(status.st_mode)) return Refused(StickRefusal::no_file);
    if (status.st_size <= 0) return Refused(StickRefusal::empty);
    if (static_cast<std::uint64_t>(status.st_size) > most_bytes)
        return Refused(StickRefusal::too_large);
    return static_cast<std::size_t>(status.st_size);
}

/// Examines it first without opening it for reading, which alone makes some devices act.
Result<Descriptor, StickRefusal> open_file(const Descriptor& folder, const std::string& name,
                                           std::size_t most_bytes) {
    const Descriptor seen = open_beneath(folder, name, O_PATH);
    if (!seen.is_open()) return refused_by_system();
    if (const auto size = size_of(seen, most_bytes); !size) return Refused(size.error());
    Descriptor file = open_beneath(folder, name, 0);
    if (!file.is_open()) return refused_by_system();
    return file;
}

Result<void, StickRefusal> copy_bytes(const Descriptor& file, std::size_t bytes,
                                      const Descriptor& output, const CopyLimits& limits) {
    std::vector<std::byte> block(block_bytes);
    std::size_t copied = 0;
    for (;;) {
        if (limits.is_time_up()) return Refused(StickRefusal::out_of_time);
        const ssize_t got = ::read(file.number(), block.data(), block.size());
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return refused_by_system();
        copied += static_cast<std::size_t>(got);
        if (copied > bytes || (got == 0 && copied < bytes))
            return Refused(StickRefusal::unreadable);
        if (got == 0) return {};
        if (!write_all(output, std::span(block).first(static_cast<std::size_t>(got))))
            return Refused(StickRefusal::too_large);
    }
}

}  // namespace

StickRefusal refusal_of(int error) {
    switch (error) {
        case ENOENT:
        case ENOTDIR:
        case ENAMETOOLONG:
            return StickRefusal::no_such_file;
        case ELOOP:  // a link
        case EXDEV:  // out of the stick
        case ENXIO:  // a socket
        case EISDIR:
            return StickRefusal::no_file;
        case EACCES:
        case EPERM:
            return StickRefusal::locked;
        case ENODEV:
        case ENOTCONN:  // a file system in user space has ended
        case ESHUTDOWN:
            return StickRefusal::gone;
        default:
            return StickRefusal::unreadable;
    }
}

Descriptor open_beneath(const Descriptor& folder, const std::string& name, int flags) {
    if ((flags & O_PATH) != 0)
        return Descriptor(openat2(folder.number(), name.c_str(), flags | O_CLOEXEC | O_NOFOLLOW));
    const int all = O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | flags;
    int number = openat2(folder.number(), name.c_str(), all | O_NOATIME);
    // Only a file's owner may keep its access time unchanged.
    if (number < 0 && errno == EPERM) number = openat2(folder.number(), name.c_str(), all);
    return Descriptor(number);
}

Result<void, StickRefusal> copy_from_stick(const Descriptor& root, const std::string& folder,
                                           const std::string& name, const Descriptor& output,
                                           const CopyLimits& limits) {
    if (!is_file_name(name) || !is_folder_path(folder)) return Refused(StickRefusal::no_such_file);
    const Descriptor open_folder =
        open_beneath(root, folder.empty() ? "." : folder, O_PATH | O_DIRECTORY);
    if (!open_folder.is_open()) return refused_by_system();
    const auto file = open_file(open_folder, name, limits.most_bytes);
    if (!file) return Refused(file.error());
    const auto bytes = size_of(*file, limits.most_bytes);
    if (!bytes) return Refused(bytes.error());
    return copy_bytes(*file, *bytes, output, limits);
}

}  // namespace touchline
