// The monotonic clock, where a deadline or a timing is asked for. Threads: any.
#pragma once

#include <chrono>
#include <cstdint>

namespace touchline {

[[nodiscard]] inline std::int64_t steady_now_ns() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

}  // namespace touchline
