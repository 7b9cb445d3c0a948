// Runs jobs beside the caller's thread; in tests, wherever and whenever the test likes.
// Threads: one, which starts jobs and takes their results.
#pragma once

#include "app/loading/load_plan.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace touchline {

struct FinishedJob {
    std::uint64_t number = 0;
    JobOutcome outcome;
};

class Executor {
  public:
    Executor() = default;
    virtual ~Executor() = default;
    Executor(const Executor&) = delete;
    Executor(Executor&&) = delete;
    Executor& operator=(const Executor&) = delete;
    Executor& operator=(Executor&&) = delete;

    /// `work` throws nothing. Never waits.
    virtual void start(std::uint64_t number, std::function<JobOutcome()> work) = 0;

    /// The jobs that ended since the last call. Never waits for one.
    [[nodiscard]] virtual std::vector<FinishedJob> take_finished() = 0;
};

}  // namespace touchline
