// Runs a renderer over the hand: what every step cost, and where the proxy went; before it the
// tools that measure: a serialised tick of the processor's clock, and the heap.
// Threads: any for the tools, which share nothing; one for a run.
#pragma once

#include "config/types/vec2.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

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

/// A gap between proxy and hand that a desk-top pantograph cannot hold (5 N at 500 N/m): the hand
/// counts as slipped off.
inline constexpr double slip_m = 0.010;

/// The hand, one position a millisecond.
struct Hand {
    std::span<const Position> positions;
    /// Whether the hand is inside the curve, for each position; empty if nothing is judged, as for
    /// queries that move no proxy.
    std::vector<bool> is_inside;
};

struct RunLimits {
    int passes = 3;
    double first_pass_s = 6.0;  // a first pass that takes longer stops early
};

struct HandRun {
    std::vector<std::uint64_t> first_ticks;  // of each step in the first pass
    std::vector<std::uint64_t> least_ticks;  // of each step, the least of all passes
    std::vector<Position> proxies;
    std::vector<bool> is_reset;  // the hand had slipped off and was taken up again at this step
    bool is_stopped = false;     // before the hand's last position
};

/// Renderer: start(hand) before a pass, step(hand) -> proxy, reset(hand) after a slip. Once the gap
/// exceeds slip_m, run() resets the renderer at the next step with the hand outside, untimed.
/// Further passes repeat the steps of the first; the least time leaves out what other programs
/// took.
template <class Renderer>
[[nodiscard]] HandRun run(Renderer& renderer, const Hand& hand, const RunLimits& limits) {
    const std::size_t count = hand.positions.size();
    HandRun result;
    result.least_ticks.assign(count, std::numeric_limits<std::uint64_t>::max());
    result.is_reset.assign(count, false);
    std::size_t steps = count;
    for (int pass = 0; pass < limits.passes; ++pass) {
        renderer.start(hand.positions[0]);
        const double begin_s = now_s();
        bool has_slipped = false;
        for (std::size_t i = 0; i < steps; ++i) {
            const Position at = hand.positions[i];
            if (has_slipped && !hand.is_inside[i]) {
                renderer.reset(at);
                has_slipped = false;
                result.is_reset[i] = true;
            }
            const std::uint64_t begin = ticks();
            const Position proxy = renderer.step(at);
            const std::uint64_t cost = ticks() - begin;
            result.least_ticks[i] = std::min(result.least_ticks[i], cost);
            has_slipped |= !hand.is_inside.empty() && norm(proxy - at) > slip_m;
            if (pass > 0) continue;
            result.first_ticks.push_back(cost);
            result.proxies.push_back(proxy);
            if (i % 64 == 63 && now_s() - begin_s > limits.first_pass_s) steps = i + 1;
        }
    }
    result.is_stopped = steps < count;
    result.least_ticks.resize(steps);
    result.is_reset.resize(steps);
    return result;
}

/// Nanoseconds per step, including the timer's own cost.
struct StepTimes {
    double median_ns = 0.0, p99_ns = 0.0, max_ns = 0.0;
};

[[nodiscard]] StepTimes step_times(std::vector<std::uint64_t> ticks_of_steps);

/// What the hand would have felt at 500 N/m.
struct Behaviour {
    std::size_t entered = 0;  // times that the proxy was inside the curve after being outside
    std::size_t slip_offs = 0;
    double contact_share = 0.0;  // of the steps, with a gap over 1 um
    double mean_gap_m = 0.0;     // of those steps
    double largest_gap_m = 0.0;
    double largest_jump_N = 0.0;  // of the force from one step to the next
};

class Inside;
inline constexpr double stiffness_N_per_m = 500.0;
[[nodiscard]] Behaviour behaviour(const HandRun& run, const Hand& hand, const Inside& is_inside);

}  // namespace touchline::bench
