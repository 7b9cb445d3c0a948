// Time for the loop: a clock behind an interface, and a schedule of the ticks.
#pragma once

#include <cstdint>

namespace touchline {

/// Threads: each implementation says.
class Clock {
  public:
    virtual ~Clock() = default;
    /// Nanoseconds since a fixed moment; never goes back.
    [[nodiscard]] virtual std::int64_t now_ns() = 0;
    /// Returns at t_ns or later; at once if that has passed.
    virtual void sleep_until(std::int64_t t_ns) = 0;

  protected:
    Clock() = default;
    Clock(const Clock&) = default;
    Clock(Clock&&) = default;
    Clock& operator=(const Clock&) = default;
    Clock& operator=(Clock&&) = default;
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

    /// Ends the tick that was due; it is now_ns.
    void finish(std::int64_t now_ns);

    [[nodiscard]] std::uint64_t missed() const { return missed_; }

  private:
    std::int64_t start_ns_;
    std::int64_t period_ns_;
    std::int64_t due_ns_;
    std::uint64_t missed_ = 0;
};

}  // namespace touchline
