// A servo process as its guard holds it: a child of the kiosk, or one of a unit of its own that
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
    /// A child.
    explicit RunningServo(Child child) : child_(std::move(child)) {}

    /// Somebody else's child.
    explicit RunningServo(Descriptor pidfd) : pidfd_(std::move(pidfd)) {}

    /// Readable as soon as it is dead, its descriptors closed.
    [[nodiscard]] const Descriptor& pidfd() const { return child_ ? child_->pidfd() : pidfd_; }

    /// SIGKILL.
    void kill() const;

    /// Once it is dead: how it ended; empty: as asked, with zero torque. Of somebody else's child
    /// only its own word is known.
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

/// Starts the program, which is told its device on its command line.
[[nodiscard]] Result<StartedServo> start_servo(const std::string& program,
                                               const std::vector<std::string>& device);

/// Asks at the path and tells whoever answers its device. Waits for it for 3 s at most.
[[nodiscard]] Result<StartedServo> summon_servo(const std::string& path,
                                                const std::vector<std::string>& device);

}  // namespace touchline
