// Asks the system for real-time behaviour of the calling thread and reports what it granted.
#pragma once

#include "haptics/servo/lateness.h"

#include <cstdint>
#include <string_view>

namespace touchline {

/// How well a loop keeps time, best first.
///   A real_time    SCHED_FIFO, memory locked, real-time kernel
///   B fifo         SCHED_FIFO on a plain kernel or with memory that may be paged
///   C best_effort  refused; finer timers only
///   D too_late     measured: too many ticks came late
enum class RealTimeTier : std::uint8_t { real_time, fifo, best_effort, too_late };

/// as_touched: unused pages take no memory, but a first touch may fault within a tick; for a
/// process that does more than the servo. whole: every page is there from the start; for a process
/// that only runs the servo.
enum class MemoryLock : std::uint8_t { as_touched, whole };

/// Gives the calling thread priority, locked memory, a touched stack, and a processor of its own if
/// there are at least four. Never fails: a refusal only lowers the tier.
[[nodiscard]] RealTimeTier become_real_time(MemoryLock lock);

/// Gives the calling thread, which watches the servo, a priority above the servo's. Does nothing if
/// the system refuses.
void become_guard();

/// Judges the granted tier by the last minute: too_late if more than 0.1 % of its ticks were later
/// than 1 ms, or if there was a gap of more than 10 ms. period_s > 0.
[[nodiscard]] RealTimeTier judge(RealTimeTier granted, const LastMinute& last_minute,
                                 double period_s);

/// What a device with motors may render in a tier: A and B everything; C half the stiffness and
/// force with more damping; D nothing.
struct TierLimits {
    double stiffness_share = 1.0;
    double force_share = 1.0;
    double extra_damping_Ns_per_m = 0.0;
};

[[nodiscard]] TierLimits limits_of(RealTimeTier tier);

/// Describes the tier to the operator in a few words, including what it means for the force.
[[nodiscard]] std::string_view describe(RealTimeTier tier);

}  // namespace touchline
