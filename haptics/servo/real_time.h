// Asks the system for real-time behaviour of the calling thread and says what it got.
#pragma once

#include <cstdint>
#include <string_view>

namespace touchline {

/// real_time: SCHED_FIFO, memory locked, real-time kernel. fifo: SCHED_FIFO on a plain kernel or
/// with memory that may be paged. best_effort: refused; finer timers only.
enum class RealTimeTier : std::uint8_t { real_time, fifo, best_effort };

/// For the thread that calls it. Never fails: what is refused lowers the tier.
[[nodiscard]] RealTimeTier become_real_time();

/// A few words for the operator.
[[nodiscard]] std::string_view describe(RealTimeTier tier);

}  // namespace touchline
