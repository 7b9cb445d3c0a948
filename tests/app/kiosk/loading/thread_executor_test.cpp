// Tests the same loading on real threads.
#include "app/kiosk/loading/loader.h"
#include "tests/app/kiosk/loading/loading_world.h"

#include <atomic>
#include <future>
#include <memory>
#include <random>
#include <thread>

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(ThreadExecutor, AnyHistoryEndsWithWhatWasWantedLast) {
    const MadeUpDocument document{.figures = std::vector<int>(5, 2)};
    std::set<std::pair<int, int>> with_words;
    for (int page = 1; page <= 5; ++page) with_words.insert({page, 2});
    const auto stages = std::make_shared<MadeUpStages>(std::vector{document, document}, with_words);
    Loader loader(stages, std::make_unique<ThreadExecutor>(2), {});
    std::mt19937 random(1);
    for (std::uint64_t request = 1; request <= 2000; ++request) {
        const int page = 1 + static_cast<int>(random() % 5);
        const int detail = 1 + static_cast<int>(random() % 5);
        const FilePtr& file = stages->files()[random() % 2];
        loader.want(request, {file, page, 2, {detail}});
        if (random() % 4 != 0) continue;
        const std::string title = MadeUpStages::title(file->name, page, 2, detail);
        for (bool is_answered = false; !is_answered; std::this_thread::yield()) {
            for (const Delivery& delivery : loader.poll()) {
                if (delivery.request != request) continue;
                ASSERT_TRUE(delivery.scene.has_value());
                EXPECT_EQ(delivery.scene->facts.title.substr(0, title.size()), title);
                is_answered = true;
            }
        }
    }
}

TEST(ThreadExecutor, JobsRunSideBySide) {
    ThreadExecutor executor(2);
    std::promise<void> second_runs;
    auto seen = second_runs.get_future();
    // The first job ends only after the second has begun.
    executor.start(1, [&seen]() -> JobOutcome {
        seen.wait();
        return Result<PagePtr>(PagePtr());
    });
    executor.start(2, [&second_runs]() -> JobOutcome {
        second_runs.set_value();
        return Result<PagePtr>(PagePtr());
    });
    std::vector<FinishedJob> finished;
    while (finished.size() < 2) {
        for (FinishedJob& job : executor.take_finished()) finished.push_back(std::move(job));
        std::this_thread::yield();
    }
    EXPECT_EQ(finished[0].number + finished[1].number, 3U);
}

TEST(ThreadExecutor, ItsEndWaitsForWhatRuns) {
    std::promise<void> begun;
    std::promise<void> goes_on;
    std::atomic<int> done{0};
    auto executor = std::make_unique<ThreadExecutor>(1);
    executor->start(1, [&]() -> JobOutcome {
        begun.set_value();
        goes_on.get_future().wait();
        ++done;
        return Result<PagePtr>(PagePtr());
    });
    begun.get_future().wait();
    std::thread end([&executor] { executor.reset(); });
    goes_on.set_value();
    end.join();
    EXPECT_EQ(done, 1);
}

}  // namespace
}  // namespace touchline
