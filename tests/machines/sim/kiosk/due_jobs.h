// Load jobs on a virtual clock: each is done when its time has come, and may fail as a worker does.
// Threads: one.
#pragma once

#include "app/kiosk/loading/loader.h"

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace touchline {

/// How a job ends: after so long, its result comes, or a failure instead.
struct JobFate {
    double after_s = 0.0;
    std::string failure;  // empty: no failure
};

class DueJobs final : public Executor {
  public:
    /// `now_s` must outlive it. `fate` decides about each job as it starts; without it, every job
    /// is done at once.
    explicit DueJobs(const double& now_s, std::function<JobFate()> fate = {})
        : now_s_(now_s), fate_(std::move(fate)) {}

    void start(std::uint64_t number, std::function<JobOutcome()> work) override {
        const JobFate fate = fate_ ? fate_() : JobFate{};
        waiting_.push_back({number, now_s_ + fate.after_s, fate.failure, std::move(work)});
    }

    [[nodiscard]] std::vector<FinishedJob> take_finished() override {
        std::vector<FinishedJob> finished;
        std::vector<Waiting> before = std::exchange(waiting_, {});
        for (Waiting& job : before) {
            if (job.due_s > now_s_)
                waiting_.push_back(std::move(job));
            else
                finished.push_back({job.number, outcome_of(job)});
        }
        return finished;
    }

    [[nodiscard]] std::size_t waiting() const { return waiting_.size(); }

  private:
    struct Waiting {
        std::uint64_t number = 0;
        double due_s = 0.0;
        std::string failure;
        std::function<JobOutcome()> work;
    };

    static JobOutcome outcome_of(const Waiting& job) {
        JobOutcome outcome = job.work();
        if (!job.failure.empty())
            std::visit([&job](auto& result) { result = failure(job.failure); }, outcome);
        return outcome;
    }

    const double& now_s_;
    std::function<JobFate()> fate_;
    std::vector<Waiting> waiting_;
};

}  // namespace touchline
