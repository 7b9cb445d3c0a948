// How late the ticks begin: all of them as a histogram, and the last minute, by which the tier is
// judged.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace touchline {

/// Bins of 1 us up to 10 ms; the last bin holds everything later. Threads: add() from one, the rest
/// from any; lock-free, also between processes.
class LatenessHistogram {
  public:
    static constexpr std::size_t bins = 10'001;

    void add(std::int64_t late_ns);

    [[nodiscard]] std::uint64_t count() const;

    /// Counts the ticks that began less than `late_us` late, 0 to 10000. O(bins).
    [[nodiscard]] std::uint64_t count_below(std::size_t late_us) const;

    /// Returns the smallest lateness, in us, that at most 1 - share of the ticks exceed; 0 <= share
    /// <= 1. Returns 0 without ticks; 10000 stands for that and more. O(bins).
    [[nodiscard]] int quantile_us(double share) const;

  private:
    static_assert(std::atomic<std::uint32_t>::is_always_lock_free);

    std::array<std::atomic<std::uint32_t>, bins> counts_{};
};

/// The histogram as a few numbers, for people.
struct LatenessBars {
    /// Upper ends, in us, of all bars but the last, which holds everything later.
    static constexpr std::array<int, 5> ends_us{20, 50, 100, 200, 1000};
    static constexpr std::size_t count = ends_us.size() + 1;

    std::array<std::uint64_t, count> ticks{};

    friend bool operator==(const LatenessBars&, const LatenessBars&) = default;
};

/// Any thread may call this while ticks are added. O(bins).
[[nodiscard]] LatenessBars bars_of(const LatenessHistogram& lateness);

/// The timing of the last minute.
struct LastMinute {
    std::uint64_t late = 0;       // ticks that began more than 1 ms late or not at all
    std::uint64_t long_gaps = 0;  // gaps of more than 10 ms between two ticks
};

/// Totals over the last minute, second by second. A plain value; O(1) a tick.
class MinuteOfTicks {
  public:
    /// Adds a tick that began at now_s (never going back), `late_s` after it was due and `gap_s`
    /// after the one before it; `skipped` ticks in between were not run.
    void add(double now_s, double late_s, double gap_s, std::uint64_t skipped);

    [[nodiscard]] const LastMinute& last_minute() const { return total_; }

  private:
    static constexpr std::size_t seconds = 60;

    void move_to(std::int64_t second);

    std::array<LastMinute, seconds> each_{};
    LastMinute total_;
    std::int64_t second_ = 0;
};

}  // namespace touchline
