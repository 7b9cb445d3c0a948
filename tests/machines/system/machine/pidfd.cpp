// Provides pidfd_open and pidfd_send_signal to a program under valgrind 3.19, which does not know
// them; loaded with LD_PRELOAD. The descriptor becomes readable when a child dies; it is made of a
// pipe and a thread that waits. Threads: any.
#include <csignal>
#include <cstddef>
#include <map>
#include <mutex>
#include <thread>

#include <fcntl.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

struct Watched {
    std::mutex mutex;
    std::map<int, pid_t> pids;  // by descriptor; a reused one belongs to another process
};

/// Never destroyed: threads may outlive main.
Watched& watched() {
    static auto* const all = new Watched;
    return *all;
}

void wait_and_close(pid_t pid, int writing) {
    siginfo_t info{};
    (void)waitid(P_PID, static_cast<id_t>(pid), &info, WEXITED | WNOWAIT);
    (void)close(writing);
}

}  // namespace

extern "C" {
int pidfd_open(pid_t pid, unsigned /*flags*/) noexcept {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return -1;
    {
        const std::lock_guard lock(watched().mutex);
        watched().pids[ends[0]] = pid;
    }
    std::thread(wait_and_close, pid, ends[1]).detach();
    return ends[0];
}

int pidfd_send_signal(int descriptor, int signal, siginfo_t* /*info*/,
                      unsigned /*flags*/) noexcept {
    const std::lock_guard lock(watched().mutex);
    const auto at = watched().pids.find(descriptor);
    return at == watched().pids.end() ? -1 : kill(at->second, signal);
}
}
