// A servo process in the hands of its guard: a child of the kiosk, or one of a unit of its own that
// systemd started when the kiosk asked at a socket. Threads: one, the guard.
#pragma once

#include "app/process/child.h"
#include "config/types/result.h"

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

}  // namespace touchline
