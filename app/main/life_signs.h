// What the kiosk tells whoever started it: that it is ready, that it lives, that it ends. systemd
// starts a kiosk again that is silent for longer than its unit says (WatchdogSec). Source:
// sd_notify(3), sd_watchdog_enabled(3). Threads: the kiosk's main thread.
#pragma once

#include <cstdint>

namespace touchline {

/// When the watchdog is fed: while both hearts beat, four times in its time. A main loop that goes
/// on says nothing of the servo, and the other way round. No clock.
class WatchdogPace {
  public:
    /// Never, for a time of 0 or less.
    explicit WatchdogPace(std::int64_t longest_silence_ns) : longest_ns_(longest_silence_ns) {}

    /// One turn of the main loop, which is the first heart; `servo_beats` counts those of the
    /// second. Whether to feed now.
    [[nodiscard]] bool step(std::int64_t now_ns, std::uint64_t servo_beats) {
        const bool is_due =
            longest_ns_ > 0 && (!has_fed_ || now_ns - fed_ns_ >= longest_ns_ / turns_of_watchdog);
        if (!is_due || (has_fed_ && servo_beats == fed_beats_)) return false;
        has_fed_ = true;
        fed_ns_ = now_ns;
        fed_beats_ = servo_beats;
        return true;
    }

  private:
    static constexpr int turns_of_watchdog = 4;

    std::int64_t longest_ns_;
    bool has_fed_ = false;
    std::int64_t fed_ns_ = 0;
    std::uint64_t fed_beats_ = 0;
};

/// Silent where nobody listens: NOTIFY_SOCKET of the environment is not set.
class LifeSigns {
  public:
    /// The time of the watchdog is that of the environment (WATCHDOG_USEC, WATCHDOG_PID).
    LifeSigns();

    /// After every frame: ready at the first, then alive. Arguments as of WatchdogPace::step().
    void beat(std::int64_t now_ns, std::uint64_t servo_beats);

    /// The force is about to fade out.
    static void end();

  private:
    WatchdogPace pace_;
    bool is_ready_ = false;
};

}  // namespace touchline
