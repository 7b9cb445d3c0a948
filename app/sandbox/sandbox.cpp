#include "app/sandbox/sandbox.h"

#include "app/sandbox/policy.h"
#include "app/sandbox/shared_machine.h"
#include "app/sandbox/worker.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>

#include <sys/prctl.h>
#include <sys/resource.h>
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

}  // namespace

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

}  // namespace touchline
