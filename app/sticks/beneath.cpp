#include "app/sticks/beneath.h"

#include <cerrno>

#include <fcntl.h>
#include <linux/openat2.h>
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

}  // namespace touchline
