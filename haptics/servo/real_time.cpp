#include "haptics/servo/real_time.h"

#include <array>
#include <cstddef>
#include <fstream>

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>

namespace touchline {
namespace {

constexpr int servo_priority = 70;  // below the kernel's own threads and a device guard
constexpr int best_effort_nice = -10;

bool schedule_fifo() {
    sched_param parameters{};
    parameters.sched_priority = servo_priority;
    return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0;
}

// Only with no limit on locked memory: with one, locking future pages makes later allocations fail.
// Pages are locked as they are touched, so nothing is paged in that nobody uses.
bool lock_memory() {
    rlimit limit{RLIM_INFINITY, RLIM_INFINITY};
    if (setrlimit(RLIMIT_MEMLOCK, &limit) != 0) return false;
    return mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) == 0;
}

// So that the tick never meets an untouched page of its stack.
void touch_stack() {
    std::array<std::byte, std::size_t{256} * 1024> stack;
    volatile std::byte* const bytes = stack.data();
    for (std::size_t i = 0; i < stack.size(); i += 4096) bytes[i] = std::byte{0};
}

bool is_real_time_kernel() {
    std::ifstream file("/sys/kernel/realtime");
    char flag = '0';
    return file.get(flag) && flag == '1';
}

}  // namespace

RealTimeTier become_real_time() {
    const bool is_fifo = schedule_fifo();
    const bool is_locked = lock_memory();
    touch_stack();
    if (is_fifo) {
        return is_locked && is_real_time_kernel() ? RealTimeTier::real_time : RealTimeTier::fifo;
    }
    // A refusal costs jitter, not the session; both calls may be refused as well.
    (void)prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);
    (void)setpriority(PRIO_PROCESS, 0, best_effort_nice);
    return RealTimeTier::best_effort;
}

std::string_view describe(RealTimeTier tier) {
    switch (tier) {
        case RealTimeTier::real_time:
            return "real-time";
        case RealTimeTier::fifo:
            return "real-time priority on a plain kernel";
        case RealTimeTier::best_effort:
            return "best effort, no real-time priority";
    }
    return "";
}

}  // namespace touchline
