// Brings pictures to the hand: the plan, the stages and the executor.
// Threads: one; no call waits.
#pragma once

#include "app/loading/executor.h"
#include "app/loading/load_plan.h"
#include "app/loading/stages.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace touchline {

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
