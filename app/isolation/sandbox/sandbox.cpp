#include "app/isolation/sandbox/sandbox.h"

#include "app/isolation/sandbox/policy.h"
#include "app/isolation/sandbox/worker.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <string>
#include <string_view>
#include <utility>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace touchline {
namespace {

/// The sanitizers map terabytes, start threads and make calls that no worker may. Their builds test
/// what the workers do, not their sandbox, and are never installed.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool is_sanitized = true;
#else
constexpr bool is_sanitized = false;
#endif

static_assert(ResourceLimit::no_limit == RLIM_INFINITY);

tl::unexpected<Error> not_entered(const std::string& step) {
    return failure("the sandbox cannot be entered: " + step + ": " + std::strerror(errno));
}

/// The C++ library would end by a signal that the filter does not allow.
[[noreturn]] void end_at_once() {
    _exit(worker_out_of_memory);
}

Result<void> belong_to_parent() {
    be_killed_first();
    if (prctl(PR_SET_PDEATHSIG, SIGKILL, 0UL, 0UL, 0UL) != 0) return not_entered("death signal");
    if (prctl(PR_SET_DUMPABLE, 0UL, 0UL, 0UL, 0UL) != 0) return not_entered("tracing");
    return {};
}

Result<void> close_what_was_not_meant() {
    if (close_range(worker_descriptors, ~0U, 0) != 0) return not_entered("descriptors");
    return {};
}

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

/// From here on this user can start most_worker_threads more, in this process or another. The limit
/// does not bind root. Takes some 0.2 ms.
Result<void> limit_threads() {
    rlimit before{};
    if (getrlimit(RLIMIT_NPROC, &before) == 0) {
        const rlim_t most =
            std::min(before.rlim_max, tasks_of_user(before.rlim_max) + most_worker_threads);
        if (set_limit(most, most)) return {};
    }
    return not_entered("threads");
}

Result<void> limit_resources(const WorkerLimits& limits) {
    if (limits.has_threads && !is_sanitized)
        if (auto limited = limit_threads(); !limited) return limited;
    for (const ResourceLimit& most : resource_limits(limits, !is_sanitized)) {
        const rlimit limit{most.soft, most.hard};
        if (setrlimit(static_cast<__rlimit_resource_t>(most.what), &limit) != 0)
            return not_entered(most.name);
    }
    return {};
}

}  // namespace

Result<void> enter_sandbox(WorkerKind kind) {
    std::set_terminate(end_at_once);
    return belong_to_parent()
        .and_then(close_what_was_not_meant)
        .and_then([kind] { return limit_resources(limits_of(kind)); })
        .and_then([kind] { return deny_files(kind); })
        .and_then([kind] { return is_sanitized ? Result<void>{} : filter_calls(kind); });
}

Result<void> enter_sandbox_beneath(const Descriptor& folder, const WorkerLimits& limits) {
    return belong_to_parent()
        .and_then([&limits] { return limit_resources(limits); })
        .and_then([&folder] { return deny_files_but_beneath(folder); })
        .and_then([] { return is_sanitized ? Result<void>{} : filter_calls_of_reading_beneath(); });
}

void be_killed_first() {
    static bool is_asked = false;
    if (std::exchange(is_asked, true)) return;
    constexpr std::string_view first_of_all = "1000";
    const Descriptor score(::open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC));
    if (score.is_open()) (void)!::write(score.number(), first_of_all.data(), first_of_all.size());
}

}  // namespace touchline
