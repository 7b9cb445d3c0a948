#include "app/speak/fence.h"

#include <csignal>
#include <string>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace touchline {
namespace {

// The standard ones and the socket: the next that would be opened has no number left.
constexpr rlim_t descriptors = 4;

bool limit(__rlimit_resource resource, rlim_t most) {
    const rlimit both{most, most};
    return setrlimit(resource, &both) == 0;
}

bool limit_memory() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    return true;  // a sanitizer's own memory is larger than any limit
#else
    return limit(RLIMIT_AS, rlim_t{256} << 20U);
#endif
}

/// The engine prints what it misses, and with it what somebody wrote; nor is a log to grow.
bool silence_streams() {
    const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
    if (nowhere < 0) return false;
    const bool is_silent = dup2(nowhere, STDIN_FILENO) >= 0 && dup2(nowhere, STDOUT_FILENO) >= 0 &&
                           dup2(nowhere, STDERR_FILENO) >= 0;
    return close(nowhere) == 0 && is_silent;
}

}  // namespace

Result<void> shut_in() {
    const pid_t parent = getppid();
    const bool is_shut_in = silence_streams() && prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0) == 0 &&
                            prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
                            prctl(PR_SET_DUMPABLE, 0, 0, 0, 0) == 0 &&
                            limit(RLIMIT_NOFILE, descriptors) && limit(RLIMIT_FSIZE, 0) &&
                            limit(RLIMIT_NPROC, 0) && limit(RLIMIT_CORE, 0) && limit_memory();
    if (!is_shut_in) return failure("The voice cannot be shut in; it says nothing.");
    if (getppid() != parent) return failure("The kiosk is gone.");
    return {};
}

}  // namespace touchline
