// Asks the system for real-time behaviour of the calling thread and says what it got.
#pragma once

#include "haptics/servo/lateness.h"

#include <cstdint>
#include <string_view>

namespace touchline {

/// How far a loop can be trusted to be in time, best first.
///   A real_time    SCHED_FIFO, memory locked, real-time kernel
///   B fifo         SCHED_FIFO on a plain kernel or with memory that may be paged
///   C best_effort  refused; finer timers only
///   D too_late     measured: too many ticks came late
enum class RealTimeTier : std::uint8_t { real_time, fifo, best_effort, too_late };

/// as_touched: what nobody uses takes no memory, but a first touch may fault in the tick; for a
/// process that does more than the servo. whole: every page is there from the start; for one that
/// does nothing else.
enum class MemoryLock : std::uint8_t { as_touched, whole };

/// For the thread that calls it: priority, locked memory, a touched stack, and a processor of its
/// own where there are at least four. Never fails: what is refused lowers the tier.
[[nodiscard]] RealTimeTier become_real_time(MemoryLock lock);

/// Above the servo, for the thread that watches it. Without effect where that is refused.
void become_guard();

/// What the last minute makes of the tier that was granted: too_late with more than 0.1 % of a
/// minute's ticks later than 1 ms, or with a gap of more than 10 ms. period_s > 0.
[[nodiscard]] RealTimeTier judge(RealTimeTier granted, const LastMinute& last_minute,
                                 double period_s);

/// What a device with motors may render in a tier: A and B everything; C half the stiffness and
/// force and more damping; D nothing.
struct TierLimits {
    double stiffness_share = 1.0;
    double force_share = 1.0;
    double extra_damping_Ns_per_m = 0.0;
};

[[nodiscard]] TierLimits limits_of(RealTimeTier tier);

/// A few words for the operator, what it means for the force included.
[[nodiscard]] std::string_view describe(RealTimeTier tier);

}  // namespace touchline
