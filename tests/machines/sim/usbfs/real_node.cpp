// A library loaded before umockdev's: it opens USB nodes as the files that they are in umockdev's
// folder, so that requests go to the file's server and not to umockdev.
#include <cstdarg>
#include <cstdlib>
#include <cstring>
#include <string>

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

constexpr const char* nodes = "/dev/bus/usb/";

int open_real(const char* name, const char* path, int flags, mode_t mode) {
    if (std::strncmp(path, nodes, std::strlen(nodes)) == 0) {
        const std::string real = std::string(std::getenv("UMOCKDEV_DIR")) + path;
        return static_cast<int>(syscall(SYS_openat, AT_FDCWD, real.c_str(), flags, mode));
    }
    const auto next = reinterpret_cast<int (*)(const char*, int, ...)>(dlsym(RTLD_NEXT, name));
    return next(path, flags, mode);
}

mode_t mode_of(int flags, va_list arguments) {
    return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(arguments, mode_t) : 0;
}

}  // namespace

extern "C" int open(const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = mode_of(flags, arguments);
    va_end(arguments);
    return open_real("open", path, flags, mode);
}

extern "C" int open64(const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = mode_of(flags, arguments);
    va_end(arguments);
    return open_real("open64", path, flags, mode);
}
