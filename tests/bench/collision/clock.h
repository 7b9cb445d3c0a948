// What the benchmark measures with: a serialised tick of the processor's clock, and the heap.
// Threads: any; nothing shared.
#pragma once

#include <cstddef>
#include <cstdint>

namespace touchline::bench {

/// The time-stamp counter, with every earlier load done and no later one begun (lfence, rdtscp,
/// lfence); on other processors than x86-64 the steady clock.
[[nodiscard]] std::uint64_t ticks();

/// Nanoseconds of one tick, calibrated against the steady clock over 0.2 s at the first call.
[[nodiscard]] double ns_per_tick();

/// Median of the ticks between two calls of ticks() with nothing between them: what the timer
/// itself adds to every step.
[[nodiscard]] std::uint64_t timer_cost_ticks();

/// Bytes that the program holds from the allocator.
[[nodiscard]] std::size_t heap_bytes();

/// Seconds of the steady clock.
[[nodiscard]] double now_s();

}  // namespace touchline::bench
