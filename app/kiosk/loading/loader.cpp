#include "app/kiosk/loading/loader.h"

#include <exception>
#include <string>
#include <utility>

namespace touchline {
namespace {

/// Memory can run out anywhere; the visit goes on.
template <class Work>
auto safely(const LoadJob& job, Work work) -> decltype(work()) {
    try {
        return work();
    } catch (const std::exception&) {
        const std::string line = "there is not enough memory for it now; choose another one";
        return failure(is_look(job.kind) ? line : job.order.file->name + ": " + line);
    }
}

JobOutcome done(const Stages& stages, const LoadJob& job) {
    const PictureFile& file = *job.order.file;
    switch (job.kind) {
        case JobKind::open:
            return safely(job, [&] { return stages.open(file, job.order.page); });
        case JobKind::find:
            return safely(
                job, [&] { return stages.find(file, job.page, job.order.view, job.order.part); });
        case JobKind::build:
            break;
        case JobKind::look:
            return safely(job, [&] { return stages.look(job.page); });
        case JobKind::look_at:
            return safely(
                job, [&] { return stages.look_at(job.page, job.order.view, *job.order.thing_at); });
        case JobKind::reread:
            return safely(job, [&] { return Result<FoundPtr>(stages.reread(*job.found)); });
    }
    return safely(job, [&] { return stages.build(file, *job.found, job.order.part); });
}

}  // namespace

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

Loader::Loader(std::shared_ptr<const Stages> stages, std::unique_ptr<Executor> executor,
               PlanLimits limits)
    : stages_(std::move(stages)),
      plan_({stages_->has_looking(), stages_->has_reading()}, limits),
      executor_(std::move(executor)) {}

void Loader::want(std::uint64_t request, const ViewOrder& order) {
    plan_.want(request, order);
    start_jobs();
}

std::vector<Delivery> Loader::poll() {
    std::vector<Delivery> deliveries;
    for (FinishedJob& job : executor_->take_finished())
        if (auto delivery = plan_.finish(job.number, std::move(job.outcome)))
            deliveries.push_back(std::move(*delivery));
    start_jobs();
    return deliveries;
}

void Loader::start_jobs() {
    for (const LoadJob& job : plan_.start())
        executor_->start(job.number, [stages = stages_, job] { return done(*stages, job); });
}

}  // namespace touchline
