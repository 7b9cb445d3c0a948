#include "tests/lab/bench/collision/run.h"

#include "tests/lab/bench/collision/brute_force.h"

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

StepTimes step_times(std::vector<std::uint64_t> ticks_of_steps) {
    std::sort(ticks_of_steps.begin(), ticks_of_steps.end());
    const auto at = [&](std::size_t rank) {
        return ns_per_tick() * static_cast<double>(ticks_of_steps[rank]);
    };
    const std::size_t count = ticks_of_steps.size();
    return {at(count / 2), at(count * 99 / 100), at(count - 1)};
}

Behaviour behaviour(const HandRun& run, const Hand& hand, const Inside& is_inside) {
    constexpr double contact_gap_m = 1e-6;
    Behaviour found;
    std::size_t contacts = 0;
    bool was_inside = false;
    Position last_gap;
    for (std::size_t i = 0; i < run.proxies.size(); ++i) {
        const bool is_in = is_inside(run.proxies[i]);
        found.entered += is_in && !was_inside ? 1 : 0;
        was_inside = is_in;
        const Position gap = run.proxies[i] - hand.positions[i];
        const double gap_m = norm(gap);
        if (gap_m > contact_gap_m) {
            ++contacts;
            found.mean_gap_m += gap_m;
        }
        found.largest_gap_m = std::max(found.largest_gap_m, gap_m);
        found.slip_offs += run.is_reset[i] ? 1U : 0U;
        const bool is_continued = i > 0 && !run.is_reset[i];
        if (is_continued) {
            found.largest_jump_N =
                std::max(found.largest_jump_N, stiffness_N_per_m * norm(gap - last_gap));
        }
        last_gap = gap;
    }
    found.contact_share = static_cast<double>(contacts) / static_cast<double>(run.proxies.size());
    if (contacts > 0) found.mean_gap_m /= static_cast<double>(contacts);
    return found;
}

}  // namespace touchline::bench
