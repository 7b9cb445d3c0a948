// A CUPS of a test's own: its settings, spool, socket and printers lie in one folder, and nothing
// of this machine's CUPS is read. Its printers are a script that does what their name says.
// Threads: the test's.
#pragma once

#include "config/types/pinned.h"

#include <filesystem>
#include <string>
#include <vector>

#include <sys/types.h>

namespace touchline {

/// What CUPS keeps of jobs: nothing of itself, all it can, or all it can whoever wants to remove
/// it.
enum class CupsKeeps : std::uint8_t { nothing, all, for_good };

/// The queues: "good" writes what it gets to printed(); "empty", "jammed" and "unplugged" tell so
/// and wait; "slow" takes a minute; "broken" gives up; "paused" is stopped; "closed" takes no jobs.
class OwnCups : private Pinned {
  public:
    /// Where cupsd is installed, or empty.
    [[nodiscard]] static std::string program();

    explicit OwnCups(CupsKeeps keeps = CupsKeeps::all);
    ~OwnCups();

    [[nodiscard]] std::string socket() const { return (folder_ / "socket").string(); }

    /// Waits until it answers; a failure of the test otherwise. Also after kill().
    void start();

    /// As a crash does.
    void kill();

    /// What "good" was given last.
    [[nodiscard]] std::string printed() const;

    /// What every backend was told of its job: user, title, options.
    [[nodiscard]] std::string told() const;

    /// Waits until a backend works on a job; false after ten seconds.
    [[nodiscard]] bool is_printing() const;

    /// The files in the spool, those being written included.
    [[nodiscard]] std::vector<std::string> spooled() const;

    /// The files of CUPS (spool, cache, state, logs) that hold these bytes.
    [[nodiscard]] std::vector<std::string> files_with(const std::string& bytes) const;

  private:
    std::filesystem::path folder_;
    pid_t pid_ = -1;
};

}  // namespace touchline
