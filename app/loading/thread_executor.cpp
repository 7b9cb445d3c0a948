#include "app/loading/thread_executor.h"

namespace touchline {

ThreadExecutor::ThreadExecutor(std::size_t threads) {
    for (std::size_t i = 0; i < threads; ++i) threads_.emplace_back([this] { run(); });
}

ThreadExecutor::~ThreadExecutor() {
    {
        const std::lock_guard lock(mutex_);
        is_ending_ = true;
    }
    changed_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

void ThreadExecutor::start(std::uint64_t number, std::function<JobOutcome()> work) {
    {
        const std::lock_guard lock(mutex_);
        waiting_.emplace_back(number, std::move(work));
    }
    changed_.notify_one();
}

std::vector<FinishedJob> ThreadExecutor::take_finished() {
    const std::lock_guard lock(mutex_);
    return std::exchange(finished_, {});
}

void ThreadExecutor::run() {
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [this] { return is_ending_ || !waiting_.empty(); });
        if (is_ending_) return;
        Waiting job = std::move(waiting_.front());
        waiting_.pop_front();
        lock.unlock();
        FinishedJob done{job.first, job.second()};
        job.second = nullptr;  // what it held is freed here, not under the lock
        lock.lock();
        finished_.push_back(std::move(done));
    }
}

}  // namespace touchline
