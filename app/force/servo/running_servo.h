// A servo process in the hands of its guard: a child of the kiosk, or one of a unit of its own that
// systemd started when the kiosk asked at a socket; when the guard kills it, and when it starts
// another. Threads: one, the guard; ServoWatch and Restart are plain values without a clock.
#pragma once

#include "app/isolation/process/child.h"
#include "config/types/result.h"
#include "haptics/servo/exchange.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace touchline {

class RunningServo {
  public:
    /// The servo is a child of this process.
    explicit RunningServo(Child child) : child_(std::move(child)) {}

    /// The servo is the child of another process.
    explicit RunningServo(Descriptor pidfd) : pidfd_(std::move(pidfd)) {}

    /// Becomes readable as soon as the servo is dead and its descriptors are closed.
    [[nodiscard]] const Descriptor& pidfd() const { return child_ ? child_->pidfd() : pidfd_; }

    /// Sends SIGKILL.
    void kill() const;

    /// How a dead servo ended; empty: as asked, with zero torque. For the child of another process,
    /// only its own message tells.
    [[nodiscard]] std::string end(bool has_said_done);

  private:
    std::optional<Child> child_;
    Descriptor pidfd_;
};

/// A servo, and the kiosk's end of the socket to it. It waits for the shared region.
struct StartedServo {
    RunningServo peer;
    Descriptor socket;
};

/// Starts the program, which gets its device on its command line.
[[nodiscard]] Result<StartedServo> start_servo(const std::string& program,
                                               const std::vector<std::string>& device);

/// Asks at the path, and tells the servo that answers its device. Waits for it for 3 s at most.
[[nodiscard]] Result<StartedServo> summon_servo(const std::string& path,
                                                const std::vector<std::string>& device);

/// The time between two looks of the guard.
inline constexpr int guard_beat_ms = 2;

/// Decides when a guard kills its servo, by the servo's channel, beat by beat.
class ServoWatch {
  public:
    /// One look, `dt_s` after the one before. `is_end_wanted`: the servo was asked to end. True if
    /// it has to be killed, because it
    ///   - is silent for 12 ms with torque on, so that the device can be opened and zeroed,
    ///   - is silent for 0.5 s without torque, when it may only have been slow,
    ///   - has not begun to tick 10 s after its start, or not ended 2 s after it was asked to.
    [[nodiscard]] bool step(const ServoChannel& channel, bool is_end_wanted, double dt_s) {
        const std::uint64_t beats = channel.servo_beats.load();
        since_start_s_ += dt_s;
        if (is_end_wanted) since_end_wanted_s_ += dt_s;
        const bool is_silent_under_force =
            under_force_.step(beats, dt_s) && channel.is_force_on.load() != 0;
        const bool is_silent = at_rest_.step(beats, dt_s);
        const bool is_overdue = since_end_wanted_s_ > longest_end_s;
        const bool is_stuck = beats != 0 ? is_silent : since_start_s_ > longest_start_s;
        return is_silent_under_force || (is_stuck && !is_end_wanted) || is_overdue;
    }

  private:
    static constexpr double longest_look_s = 2.0 * guard_beat_ms * 1e-3;
    static constexpr double longest_silence_under_force_s = 0.012;
    static constexpr double longest_silence_s = 0.5;
    static constexpr double longest_start_s = 10.0;
    static constexpr double longest_end_s = 2.0;

    PeerWatch under_force_{longest_silence_under_force_s, longest_look_s};
    PeerWatch at_rest_{longest_silence_s, longest_look_s};
    double since_start_s_ = 0.0;
    double since_end_wanted_s_ = 0.0;
};

/// Decides when a servo that died is started again. Waits half a second at first, doubled with each
/// death, 8 s at most. A servo that ran for a minute resets the wait.
class Restart {
  public:
    static constexpr double first_s = 0.5;
    static constexpr double longest_s = 8.0;
    static constexpr double healthy_s = 60.0;

    /// The wait after a servo that ran for `ran_s`.
    [[nodiscard]] double wait_s(double ran_s) {
        const double wait_s = ran_s >= healthy_s ? first_s : next_s_;
        next_s_ = std::min(2.0 * wait_s, longest_s);
        return wait_s;
    }

  private:
    double next_s_ = first_s;
};

}  // namespace touchline
