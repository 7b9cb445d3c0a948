// Tells systemd that the kiosk is ready, that it lives, and that it ends. systemd restarts a kiosk
// that is silent for longer than its unit allows (WatchdogSec). Source: sd_notify(3),
// sd_watchdog_enabled(3). Threads: the kiosk's main thread.
#pragma once

#include <cstdint>

namespace touchline {

/// Decides when to feed the watchdog: while both main loop and servo are alive, four times in its
/// period. A running main loop says nothing about the servo, and the other way round. No clock.
class WatchdogPace {
  public:
    /// Never feeds if the time is 0 or less.
    explicit WatchdogPace(std::int64_t longest_silence_ns) : longest_ns_(longest_silence_ns) {}

    /// One turn of the main loop; `servo_beats` counts the servo's. Returns whether to feed now.
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

/// Silent if nobody listens: NOTIFY_SOCKET of the environment is not set.
class LifeSigns {
  public:
    /// The environment tells the watchdog's time (WATCHDOG_USEC, WATCHDOG_PID).
    LifeSigns();

    /// Call it after every frame: it reports ready at the first, then alive. Arguments as for
    /// WatchdogPace::step().
    void beat(std::int64_t now_ns, std::uint64_t servo_beats);

    /// The force is about to fade out.
    static void end();

  private:
    WatchdogPace pace_;
    bool is_ready_ = false;
};

}  // namespace touchline
