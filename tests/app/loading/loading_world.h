// A loader, its jobs, which wait for the test, and everything that it delivered. Threads: one.
#pragma once

#include "app/loading/loader.h"
#include "tests/app/loading/made_up_stages.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace touchline {

/// Jobs wait until the test ends them.
class HeldJobs final : public Executor {
  public:
    void start(std::uint64_t number, std::function<JobOutcome()> work) override {
        held_.emplace_back(number, std::move(work));
        most_at_once = std::max(most_at_once, held_.size());
    }

    std::vector<FinishedJob> take_finished() override { return std::exchange(finished_, {}); }

    [[nodiscard]] std::size_t held() const { return held_.size(); }

    void end(std::size_t which) {
        const auto at = held_.begin() + static_cast<std::ptrdiff_t>(which);
        finished_.push_back({at->first, at->second()});
        held_.erase(at);
    }

    std::size_t most_at_once = 0;

  private:
    std::vector<std::pair<std::uint64_t, std::function<JobOutcome()>>> held_;
    std::vector<FinishedJob> finished_;
};

/// A loader, its jobs and everything that it delivered.
struct World {
    explicit World(std::vector<MadeUpDocument> documents,
                   std::optional<MadeUpStages::Places> with_words = {}, PlanLimits limits = {},
                   bool finds_things = false)
        : stages(std::make_shared<MadeUpStages>(std::move(documents), std::move(with_words),
                                                finds_things)),
          jobs(new HeldJobs),
          loader(stages, std::unique_ptr<Executor>(jobs), limits) {}

    void want(int page, int view, int detail = 3, std::size_t file = 0) {
        loader.want(++request, {stages->files().at(file), page, view, {detail}});
    }

    /// Asks for the thing at a place of a view.
    void want_thing(int view, const Position& place) {
        loader.want(++request, {stages->files().at(0), 1, view, {3}, place});
    }

    void end(std::size_t which = 0) {
        jobs->end(which);
        poll();
    }

    void poll() {
        for (Delivery& delivery : loader.poll()) delivered.push_back(std::move(delivery));
    }

    /// Ends jobs until the last request has an answer. Background work goes on.
    void until_felt() {
        const std::size_t before = delivered.size();
        while (delivered.size() == before && jobs->held() > 0) end(jobs->held() - 1);
    }

    void until_idle() {
        poll();
        while (jobs->held() > 0) end();
    }

    [[nodiscard]] std::string last() const {
        if (delivered.empty()) return "nothing";
        const auto& scene = delivered.back().scene;
        return scene ? scene->facts.title : scene.error().line;
    }

    std::shared_ptr<MadeUpStages> stages;
    HeldJobs* jobs;
    Loader loader;
    std::uint64_t request = 0;
    std::vector<Delivery> delivered;
};

inline MadeUpDocument three_pages() {
    return {.figures = {2, 0, 1}};
}

}  // namespace touchline
