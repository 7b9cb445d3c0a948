// Checks that nothing piles up.
#pragma once

#include "tests/machines/sim/kiosk/checkers/sight.h"

#include <fmt/format.h>

namespace touchline {

class QueuesChecker {
  public:
    void look(const FrameSight& sight, Findings& findings) {
        const auto demand = [&](bool holds, const char* what, std::size_t count) {
            findings.demand(holds, "queues", sight.now_s,
                            [&] { return fmt::format("{} {}", count, what); });
        };
        const std::size_t screens = sight.kiosk.visit().visitor.path.size();
        demand(sight.jobs <= most_jobs, "jobs of loading wait", sight.jobs);
        demand(sight.dropped_events == 0, "events of the hand were dropped",
               static_cast<std::size_t>(sight.dropped_events));
        demand(screens >= 1 && screens <= most_screens, "screens lie on each other", screens);
    }

  private:
    static constexpr std::size_t most_jobs = 8;  // two at a time, and those of the visit before
    static constexpr std::size_t most_screens = 8;
};

}  // namespace touchline
