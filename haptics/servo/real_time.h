// How well a loop keeps time: the clock and the schedule of its ticks, what it asks of the system,
// how late its ticks begin, and the tier that follows, by which a device with motors may push.
#pragma once

#include "config/types/pinned.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include <sched.h>

namespace touchline {

/// Threads: each implementation says.
class Clock : public Interface {
  public:
    /// Nanoseconds since a fixed moment; never goes back.
    [[nodiscard]] virtual std::int64_t now_ns() = 0;
    /// Returns at t_ns or later; at once if that has passed.
    virtual void sleep_until(std::int64_t t_ns) = 0;
};

/// CLOCK_MONOTONIC. Threads: any.
class MonotonicClock final : public Clock {
  public:
    [[nodiscard]] std::int64_t now_ns() override;
    void sleep_until(std::int64_t t_ns) override;
};

/// Schedules ticks on an even grid. A tick that could not begin within its own period is skipped
/// and counted, never made up for: a burst of late ticks would act on old positions.
class TickSchedule {
  public:
    /// The first tick is due at start_ns. period_ns > 0.
    TickSchedule(std::int64_t start_ns, std::int64_t period_ns)
        : start_ns_(start_ns), period_ns_(period_ns), due_ns_(start_ns) {}

    [[nodiscard]] std::int64_t due_ns() const { return due_ns_; }

    /// When the tick is due, counted from the first tick.
    [[nodiscard]] double due_s() const { return static_cast<double>(due_ns_ - start_ns_) * 1e-9; }

    /// Ends the tick that was due; it is now_ns. The next one is due `periods` >= 1 later.
    void finish(std::int64_t now_ns, std::int64_t periods = 1);

    [[nodiscard]] std::uint64_t missed() const { return missed_; }

  private:
    std::int64_t start_ns_;
    std::int64_t period_ns_;
    std::int64_t due_ns_;
    std::uint64_t missed_ = 0;
};

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

/// Returns the last processor in `allowed`, which is not empty: interrupts and windows use the
/// first ones.
[[nodiscard]] inline std::size_t servos_processor(const cpu_set_t& allowed) {
    std::size_t last = CPU_SETSIZE - 1;
    while (last > 0 && !CPU_ISSET(last, &allowed)) --last;
    return last;
}

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
