// Runs jobs on its own threads, as many at a time as there are threads.
// Threads: as Executor; its own threads end with it.
#pragma once

#include "app/loading/executor.h"

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

namespace touchline {

class ThreadExecutor final : public Executor {
  public:
    explicit ThreadExecutor(std::size_t threads);

    /// Waits for the running jobs and drops those not begun.
    ~ThreadExecutor() override;
    ThreadExecutor(const ThreadExecutor&) = delete;
    ThreadExecutor(ThreadExecutor&&) = delete;
    ThreadExecutor& operator=(const ThreadExecutor&) = delete;
    ThreadExecutor& operator=(ThreadExecutor&&) = delete;

    void start(std::uint64_t number, std::function<JobOutcome()> work) override;
    [[nodiscard]] std::vector<FinishedJob> take_finished() override;

  private:
    using Waiting = std::pair<std::uint64_t, std::function<JobOutcome()>>;

    void run();

    std::mutex mutex_;  // for all below except the threads
    std::condition_variable changed_;
    std::deque<Waiting> waiting_;
    std::vector<FinishedJob> finished_;
    bool is_ending_ = false;
    std::vector<std::thread> threads_;
};

}  // namespace touchline
