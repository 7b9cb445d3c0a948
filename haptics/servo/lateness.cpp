#include "haptics/servo/lateness.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

constexpr double late_s = 1e-3;
constexpr double long_gap_s = 10e-3;

}  // namespace

void LatenessHistogram::add(std::int64_t late_ns) {
    const std::int64_t bin = std::clamp(late_ns / 1000, std::int64_t{0}, std::int64_t{bins - 1});
    // There is one writer, so nothing comes between reading and writing.
    std::atomic<std::uint32_t>& count = counts_[static_cast<std::size_t>(bin)];
    count.store(count.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
}

std::uint64_t LatenessHistogram::count() const {
    return count_below(bins);
}

std::uint64_t LatenessHistogram::count_below(std::size_t late_us) const {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < std::min(late_us, bins); ++i)
        sum += counts_[i].load(std::memory_order_relaxed);
    return sum;
}

int LatenessHistogram::quantile_us(double share) const {
    const double wanted = std::ceil(share * static_cast<double>(count()));
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < bins; ++i) {
        sum += counts_[i].load(std::memory_order_relaxed);
        if (static_cast<double>(sum) >= std::max(wanted, 1.0)) return static_cast<int>(i);
    }
    return 0;
}

void MinuteOfTicks::move_to(std::int64_t second) {
    const auto passed = std::min(second - second_, static_cast<std::int64_t>(seconds));
    for (std::int64_t i = 1; i <= passed; ++i) {
        LastMinute& oldest = each_[static_cast<std::size_t>(second_ + i) % seconds];
        total_.late -= oldest.late;
        total_.long_gaps -= oldest.long_gaps;
        oldest = {};
    }
    second_ = second;
}

LatenessBars bars_of(const LatenessHistogram& lateness) {
    LatenessBars bars;
    std::uint64_t before = 0;
    for (std::size_t i = 0; i < LatenessBars::ends_us.size(); ++i) {
        const std::uint64_t below =
            lateness.count_below(static_cast<std::size_t>(LatenessBars::ends_us.at(i)));
        bars.ticks.at(i) = below - std::min(before, below);
        before = std::max(before, below);
    }
    bars.ticks.back() = lateness.count() - std::min(before, lateness.count());
    return bars;
}

void MinuteOfTicks::add(double now_s, double tick_late_s, double gap_s, std::uint64_t skipped) {
    const auto second = static_cast<std::int64_t>(now_s);
    if (second > second_) move_to(second);
    const std::uint64_t late = skipped + (tick_late_s > late_s ? 1U : 0U);
    const std::uint64_t gaps = gap_s > long_gap_s ? 1U : 0U;
    LastMinute& now = each_[static_cast<std::size_t>(second_) % seconds];
    now.late += late;
    now.long_gaps += gaps;
    total_.late += late;
    total_.long_gaps += gaps;
}

}  // namespace touchline
