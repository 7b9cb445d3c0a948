// The kiosk's program as a process on a display of its own. Threads: one.
#pragma once

#include "app/isolation/process/child.h"
#include "config/types/pinned.h"

#include <string>
#include <vector>

namespace touchline {

class RunningKiosk : private Pinned {
  public:
    /// Starts the program, full screen, with these files, and waits until its first frame is
    /// shown. Ends this program with one line on stderr if that takes a minute.
    explicit RunningKiosk(const std::string& program, const std::vector<std::string>& files = {});

    /// Asks it to end, and waits for it.
    ~RunningKiosk();

    /// Seconds until its first frame was shown: the screen that waits for a visitor.
    [[nodiscard]] double start_s() const { return start_s_; }

    [[nodiscard]] pid_t pid() const { return child_.pid(); }

  private:
    double start_s_ = 0.0;
    Child child_;
};

}  // namespace touchline
