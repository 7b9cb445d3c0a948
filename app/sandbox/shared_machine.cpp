#include "app/sandbox/shared_machine.h"

#include "app/process/descriptor.h"
#include "app/sandbox/limits.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace touchline {
namespace {

constexpr rlim_t first_guess = 64;
constexpr rlim_t close_enough = 8;
constexpr rlim_t most_tasks = rlim_t{1} << 22U;  // the kernel's limit

bool set_limit(rlim_t soft, rlim_t hard) {
    const rlimit limit{soft, hard};
    return setrlimit(RLIMIT_NPROC, &limit) == 0;
}

/// True if the kernel would start one more process with this limit.
bool is_room_within(rlim_t tasks, rlim_t hard) {
    if (!set_limit(std::min(tasks, hard), hard)) return false;
    const pid_t child = vfork();
    if (child == 0) _exit(0);
    if (child > 0) (void)waitpid(child, nullptr, 0);
    return child > 0;
}

/// How many processes and threads this user has, as the kernel counts them, or a few more. Finds
/// the number by trying, because our own processes that cannot be traced are hidden in /proc.
rlim_t tasks_of_user(rlim_t hard) {
    rlim_t without = 0;
    rlim_t with = first_guess;
    for (; with < std::min(hard, most_tasks) && !is_room_within(with, hard); with *= 2)
        without = with;
    while (with - without > close_enough) {
        const rlim_t between = without + (with - without) / 2;
        (is_room_within(between, hard) ? with : without) = between;
    }
    return with;
}

}  // namespace

void be_killed_first() {
    static bool is_asked = false;
    if (std::exchange(is_asked, true)) return;
    constexpr std::string_view first_of_all = "1000";
    const Descriptor score(::open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC));
    if (score.is_open()) (void)!::write(score.number(), first_of_all.data(), first_of_all.size());
}

Result<void> limit_threads() {
    rlimit before{};
    if (getrlimit(RLIMIT_NPROC, &before) == 0) {
        const rlim_t most =
            std::min(before.rlim_max, tasks_of_user(before.rlim_max) + most_worker_threads);
        if (set_limit(most, most)) return {};
    }
    return failure(std::string("the sandbox cannot be entered: threads: ") + std::strerror(errno));
}

}  // namespace touchline
