#include "haptics/servo/real_time.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <ctime>
#include <fstream>

#include <pthread.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>

namespace touchline {
namespace {

constexpr std::int64_t ns_per_s = 1'000'000'000;

constexpr double late_s = 1e-3;
constexpr double long_gap_s = 10e-3;

constexpr int servo_priority = 70;  // below the kernel's own threads
constexpr int guard_priority = 80;
constexpr int enough_processors = 4;  // so that one can be given away
constexpr double late_share = 1e-3;   // of a minute's ticks
constexpr int best_effort_nice = -10;

bool schedule_fifo(int priority) {
    sched_param parameters{};
    parameters.sched_priority = priority;
    return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0;
}

// Locks only if locked memory has no limit: with a limit, locking future pages makes later
// allocations fail.
bool lock_memory(MemoryLock lock) {
    rlimit limit{RLIM_INFINITY, RLIM_INFINITY};
    if (setrlimit(RLIMIT_MEMLOCK, &limit) != 0) return false;
    const int on_fault = lock == MemoryLock::as_touched ? MCL_ONFAULT : 0;
    return mlockall(MCL_CURRENT | MCL_FUTURE | on_fault) == 0;
}

void take_a_processor() {
    cpu_set_t allowed;
    if (sched_getaffinity(0, sizeof allowed, &allowed) != 0) return;
    if (CPU_COUNT(&allowed) < enough_processors) return;
    cpu_set_t own;
    CPU_ZERO(&own);
    CPU_SET(servos_processor(allowed), &own);
    (void)pthread_setaffinity_np(pthread_self(), sizeof own, &own);
}

// Touches the stack so that the tick never meets an untouched page.
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

std::int64_t MonotonicClock::now_ns() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return std::int64_t{now.tv_sec} * ns_per_s + std::int64_t{now.tv_nsec};
}

void MonotonicClock::sleep_until(std::int64_t t_ns) {
    const timespec until{t_ns / ns_per_s, t_ns % ns_per_s};
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
    }
}

void TickSchedule::finish(std::int64_t now_ns, std::int64_t periods) {
    due_ns_ += periods * period_ns_;
    const std::int64_t late_ns = now_ns - due_ns_;
    if (late_ns < period_ns_) return;
    const std::int64_t skipped = late_ns / period_ns_;
    due_ns_ += skipped * period_ns_;
    missed_ += static_cast<std::uint64_t>(skipped);
}

void LatenessHistogram::add(std::int64_t late_ns) {
    const std::int64_t bin = std::clamp(late_ns / 1000, std::int64_t{0}, std::int64_t{bins - 1});
    // There is one writer, so nothing comes between reading and writing.
    std::atomic<std::uint32_t>& count = counts_[static_cast<std::size_t>(bin)];
    count.store(count.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
}

std::uint64_t LatenessHistogram::count() const {
    return count_below(bins);
}

std::uint64_t LatenessHistogram::count_below(std::size_t late_us) const {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < std::min(late_us, bins); ++i)
        sum += counts_[i].load(std::memory_order_relaxed);
    return sum;
}

int LatenessHistogram::quantile_us(double share) const {
    const double wanted = std::ceil(share * static_cast<double>(count()));
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < bins; ++i) {
        sum += counts_[i].load(std::memory_order_relaxed);
        if (static_cast<double>(sum) >= std::max(wanted, 1.0)) return static_cast<int>(i);
    }
    return 0;
}

void MinuteOfTicks::move_to(std::int64_t second) {
    const auto passed = std::min(second - second_, static_cast<std::int64_t>(seconds));
    for (std::int64_t i = 1; i <= passed; ++i) {
        LastMinute& oldest = each_[static_cast<std::size_t>(second_ + i) % seconds];
        total_.late -= oldest.late;
        total_.long_gaps -= oldest.long_gaps;
        oldest = {};
    }
    second_ = second;
}

LatenessBars bars_of(const LatenessHistogram& lateness) {
    LatenessBars bars;
    std::uint64_t before = 0;
    for (std::size_t i = 0; i < LatenessBars::ends_us.size(); ++i) {
        const std::uint64_t below =
            lateness.count_below(static_cast<std::size_t>(LatenessBars::ends_us.at(i)));
        bars.ticks.at(i) = below - std::min(before, below);
        before = std::max(before, below);
    }
    bars.ticks.back() = lateness.count() - std::min(before, lateness.count());
    return bars;
}

void MinuteOfTicks::add(double now_s, double tick_late_s, double gap_s, std::uint64_t skipped) {
    const auto second = static_cast<std::int64_t>(now_s);
    if (second > second_) move_to(second);
    const std::uint64_t late = skipped + (tick_late_s > late_s ? 1U : 0U);
    const std::uint64_t gaps = gap_s > long_gap_s ? 1U : 0U;
    LastMinute& now = each_[static_cast<std::size_t>(second_) % seconds];
    now.late += late;
    now.long_gaps += gaps;
    total_.late += late;
    total_.long_gaps += gaps;
}

RealTimeTier become_real_time(MemoryLock lock) {
    const bool is_fifo = schedule_fifo(servo_priority);
    const bool is_locked = lock_memory(lock);
    touch_stack();
    if (is_fifo) {
        take_a_processor();
        return is_locked && is_real_time_kernel() ? RealTimeTier::real_time : RealTimeTier::fifo;
    }
    // A refusal costs jitter, not the session, so both results are ignored.
    (void)prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);
    (void)setpriority(PRIO_PROCESS, 0, best_effort_nice);
    return RealTimeTier::best_effort;
}

void become_guard() {
    if (schedule_fifo(guard_priority)) return;
    (void)prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);
}

RealTimeTier judge(RealTimeTier granted, const LastMinute& last_minute, double period_s) {
    const double most_late = late_share * 60.0 / period_s;
    const bool is_in_time =
        static_cast<double>(last_minute.late) <= most_late && last_minute.long_gaps == 0;
    return is_in_time ? granted : RealTimeTier::too_late;
}

TierLimits limits_of(RealTimeTier tier) {
    switch (tier) {
        case RealTimeTier::real_time:
        case RealTimeTier::fifo:
            return {};
        case RealTimeTier::best_effort:
            return {0.5, 0.5, 0.5};
        case RealTimeTier::too_late:
            break;
    }
    return {0.5, 0.0, 0.5};
}

std::string_view describe(RealTimeTier tier) {
    switch (tier) {
        case RealTimeTier::real_time:
            return "A, real-time";
        case RealTimeTier::fifo:
            return "B, real-time priority on a plain kernel";
        case RealTimeTier::best_effort:
            return "C, no real-time priority: a device is held to half its force";
        case RealTimeTier::too_late:
            return "D, this computer is too busy to be safe: a device makes no force, sound goes "
                   "on";
    }
    return "";
}

}  // namespace touchline
