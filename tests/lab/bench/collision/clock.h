// The benchmark's measuring tools: a serialised tick of the processor's clock, and the heap.
// Threads: any; nothing shared.
#pragma once

#include <cstddef>
#include <cstdint>

namespace touchline::bench {

/// Returns the time-stamp counter, after every earlier load and before any later one (lfence,
/// rdtscp, lfence); on processors other than x86-64 the steady clock.
[[nodiscard]] std::uint64_t ticks();

/// Returns the nanoseconds of one tick, calibrated against the steady clock over 0.2 s at the first
/// call.
[[nodiscard]] double ns_per_tick();

/// Returns the median of the ticks between two consecutive calls of ticks(): what the timer itself
/// adds to every step.
[[nodiscard]] std::uint64_t timer_cost_ticks();

/// Returns the bytes that the program holds from the allocator.
[[nodiscard]] std::size_t heap_bytes();

/// Returns the seconds of the steady clock.
[[nodiscard]] double now_s();

}  // namespace touchline::bench
