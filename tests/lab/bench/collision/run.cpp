#include "tests/lab/bench/collision/run.h"

#include "tests/lab/bench/collision/inside.h"

namespace touchline::bench {

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
