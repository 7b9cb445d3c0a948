// A child process, as its parent manages it.
// Threads: one at a time; the thread that starts the child must outlive it, for the child may die
// with that thread.
#pragma once

#include "app/isolation/process/descriptor.h"
#include "config/types/result.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <sys/types.h>

namespace touchline {

/// How a process ended: its exit status, or the signal that killed it.
struct ChildEnd {
    int status = 0;
    int signal = 0;

    [[nodiscard]] bool is_good() const { return status == 0 && signal == 0; }

    friend bool operator==(const ChildEnd&, const ChildEnd&) = default;
};

/// "exit status 1", "signal 9".
[[nodiscard]] std::string describe(const ChildEnd& end);

/// The child's standard input, output and errors: ours, or nothing.
enum class StandardStreams : std::uint8_t { ours, nothing };

class Child {
  public:
    /// Runs `program arguments...`. It gets the standard descriptors and `handed`, as first_handed,
    /// first_handed + 1, ...; its environment is ours, except for `settings` ("NAME=value").
    [[nodiscard]] static Result<Child> start(const std::string& program,
                                             const std::vector<std::string>& arguments,
                                             std::span<const Descriptor* const> handed,
                                             StandardStreams streams = StandardStreams::ours,
                                             const std::vector<std::string>& settings = {});

    static constexpr int first_handed = 3;

    /// Readable as soon as the child is dead and its descriptors are closed.
    [[nodiscard]] const Descriptor& pidfd() const { return pidfd_; }

    /// Waits until it is dead, at most this long; false if the time is up. Infinity: no limit.
    [[nodiscard]] bool ends_within(double seconds) const;

    /// Call it once the child is dead.
    [[nodiscard]] ChildEnd reap();

    /// Sends SIGKILL.
    void kill() const;

    [[nodiscard]] pid_t pid() const { return pid_; }

  private:
    Child(pid_t pid, Descriptor pidfd) : pid_(pid), pidfd_(std::move(pidfd)) {}

    pid_t pid_;
    Descriptor pidfd_;
};

}  // namespace touchline
