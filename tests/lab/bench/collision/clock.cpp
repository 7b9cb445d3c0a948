#include "tests/lab/bench/collision/clock.h"

#include <algorithm>
#include <array>
#include <chrono>

#include <malloc.h>
#ifdef __x86_64__
#include <x86intrin.h>
#endif

namespace touchline::bench {

#ifdef __x86_64__
std::uint64_t ticks() {
    unsigned processor = 0;
    _mm_lfence();
    const std::uint64_t now = __rdtscp(&processor);
    _mm_lfence();
    return now;
}
#else
std::uint64_t ticks() {
    return static_cast<std::uint64_t>(std::chrono::steady_clock::now().time_since_epoch().count());
}
#endif

double now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

double ns_per_tick() {
    static const double calibrated = [] {
        constexpr double calibration_s = 0.2;
        const double begin_s = now_s();
        const std::uint64_t begin = ticks();
        while (now_s() - begin_s < calibration_s) {
        }
        const double elapsed_ns = (now_s() - begin_s) * 1e9;
        return elapsed_ns / static_cast<double>(ticks() - begin);
    }();
    return calibrated;
}

std::uint64_t timer_cost_ticks() {
    std::array<std::uint64_t, 10001> costs{};
    for (std::uint64_t& cost : costs) {
        const std::uint64_t begin = ticks();
        cost = ticks() - begin;
    }
    auto* const middle = costs.begin() + costs.size() / 2;
    std::nth_element(costs.begin(), middle, costs.end());
    return *middle;
}

std::size_t heap_bytes() {
    const struct mallinfo2 state = mallinfo2();
    return state.uordblks + state.hblkhd;
}

}  // namespace touchline::bench
