// The program's own calls are found before those of the C library, also by other libraries.
#include "tests/app/house/lost_power.h"

#include <cstdlib>
#include <string>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

int steps_left = 0;  // 0: the power stays
constexpr int lost_status = 71;

void come_to_step() {
    if (steps_left > 0 && --steps_left == 0) ::_exit(lost_status);
}

template <class... Arguments>
auto called(long number, Arguments... arguments) {
    come_to_step();
    return ::syscall(number, arguments...);
}

}  // namespace

extern "C" {

int rename(const char* from, const char* to) noexcept {
    return static_cast<int>(called(SYS_renameat, AT_FDCWD, from, AT_FDCWD, to));
}

int link(const char* from, const char* to) noexcept {
    return static_cast<int>(called(SYS_linkat, AT_FDCWD, from, AT_FDCWD, to, 0));
}

int unlink(const char* path) noexcept {
    return static_cast<int>(called(SYS_unlinkat, AT_FDCWD, path, 0));
}

int unlinkat(int folder, const char* path, int flags) noexcept {
    return static_cast<int>(called(SYS_unlinkat, folder, path, flags));
}

int mkdir(const char* path, mode_t mode) noexcept {
    return static_cast<int>(called(SYS_mkdirat, AT_FDCWD, path, mode));
}

/// A step, but no wait for the disk: thousands of them would take the test a minute.
int fsync(int /*file*/) {
    come_to_step();
    return 0;
}

ssize_t write(int file, const void* bytes, size_t count) {
    return called(SYS_write, file, bytes, count);
}
}

namespace touchline {

bool ends_before_step(int step, const std::function<void()>& work) {
    const pid_t child = ::fork();
    if (child == 0) {
        steps_left = step;
        work();
        ::_exit(0);
    }
    int status = 0;
    if (::waitpid(child, &status, 0) != child || !WIFEXITED(status)) std::abort();
    if (WEXITSTATUS(status) != 0 && WEXITSTATUS(status) != lost_status) std::abort();
    return WEXITSTATUS(status) == 0;
}

}  // namespace touchline
