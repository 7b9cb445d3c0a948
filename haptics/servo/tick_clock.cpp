#include "haptics/servo/tick_clock.h"

#include <cerrno>
#include <ctime>

namespace touchline {
namespace {

constexpr std::int64_t ns_per_s = 1'000'000'000;

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

void TickSchedule::finish(std::int64_t now_ns) {
    due_ns_ += period_ns_;
    const std::int64_t late_ns = now_ns - due_ns_;
    if (late_ns < period_ns_) return;
    const std::int64_t skipped = late_ns / period_ns_;
    due_ns_ += skipped * period_ns_;
    missed_ += static_cast<std::uint64_t>(skipped);
}

}  // namespace touchline
