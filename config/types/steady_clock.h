// The monotonic clock, for deadlines and timings, and the sleep that it does not count.
// Threads: any.
#pragma once

#include <chrono>
#include <cstdint>
#include <ctime>

namespace touchline {

[[nodiscard]] inline std::int64_t steady_now_ns() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// Returns how long the machine has slept since it was switched on. Too little by the time that
/// passes within the call, never too much.
[[nodiscard]] inline std::int64_t slept_ns() {
    timespec with_sleep{};
    timespec without{};
    clock_gettime(CLOCK_BOOTTIME, &with_sleep);
    clock_gettime(CLOCK_MONOTONIC, &without);
    return (with_sleep.tv_sec - without.tv_sec) * 1'000'000'000 + with_sleep.tv_nsec -
           without.tv_nsec;
}

}  // namespace touchline
