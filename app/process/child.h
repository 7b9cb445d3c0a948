// A servo process as its parent holds it.
// Threads: one at a time; the thread that starts the child must outlive it, for the child dies with
// that thread.
#pragma once

#include "app/servo/sealed_memory.h"
#include "config/types/result.h"

#include <string>
#include <vector>

#include <sys/types.h>

namespace touchline {

class Child {
  public:
    /// Runs `program SOCKET arguments...`, where SOCKET is the number of `socket` over there. No
    /// other descriptor is handed on but the standard ones.
    [[nodiscard]] static Result<Child> start(const std::string& program,
                                             const std::vector<std::string>& arguments,
                                             const Descriptor& socket);

    /// Readable as soon as the child is dead, its descriptors closed.
    [[nodiscard]] const Descriptor& pidfd() const { return pidfd_; }

    /// Once it is dead: empty for exit status 0, else "exit status 1", "signal 9".
    [[nodiscard]] std::string reap();

    /// SIGKILL.
    void kill() const;

    [[nodiscard]] pid_t pid() const { return pid_; }

  private:
    Child(pid_t pid, Descriptor pidfd) : pid_(pid), pidfd_(std::move(pidfd)) {}

    pid_t pid_;
    Descriptor pidfd_;
};

}  // namespace touchline
