// Brings pictures to the hand: the plan, the stages, and where they are done.
// Threads: one; no call waits.
#pragma once

#include "app/kiosk/loading/load_plan.h"
#include "app/kiosk/loading/stages.h"
#include "config/types/pinned.h"

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace touchline {

struct FinishedJob {
    std::uint64_t number = 0;
    JobOutcome outcome;
};

/// Runs jobs beside the caller's thread; in tests, wherever and whenever the test likes. One thread
/// starts jobs and takes their results.
class Executor : public Interface {
  public:
    /// `work` throws nothing. Never waits.
    virtual void start(std::uint64_t number, std::function<JobOutcome()> work) = 0;

    /// The jobs that ended since the last call. Never waits for one.
    [[nodiscard]] virtual std::vector<FinishedJob> take_finished() = 0;
};

/// Runs jobs on its own threads, as many at a time as there are threads. They end with it.
class ThreadExecutor final : public Executor {
  public:
    explicit ThreadExecutor(std::size_t threads);

    /// Waits for the running jobs and drops those not begun.
    ~ThreadExecutor() override;

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

class Loader {
  public:
    Loader(std::shared_ptr<const Stages> stages, std::unique_ptr<Executor> executor,
           PlanLimits limits = {});

    /// As LoadPlan::want(), and starts at once.
    void want(std::uint64_t request, const ViewOrder& order);

    /// What became ready. Call it often, because it also starts what comes next.
    [[nodiscard]] std::vector<Delivery> poll();

    /// As LoadPlan::take_things(); call it after poll().
    [[nodiscard]] std::optional<ThingsFound> take_things() { return plan_.take_things(); }

    /// As LoadPlan::cancel().
    void cancel() { plan_.cancel(); }

    /// As LoadPlan::forget().
    void forget() { plan_.forget(); }

    [[nodiscard]] std::size_t kept_bytes() const { return plan_.kept_bytes(); }

  private:
    void start_jobs();

    std::shared_ptr<const Stages> stages_;
    LoadPlan plan_;
    std::unique_ptr<Executor> executor_;  // its jobs end before what they use
};

}  // namespace touchline
