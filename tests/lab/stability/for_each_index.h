// Shares the same work for many indices out over the processors; the result does not depend on how.
// Threads: `work` is called from several at once, each index once.
#pragma once

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace touchline::stability {

/// Calls work(i) for i = 0 ... count - 1. `work` must not throw.
template <class Work>
void for_each_index(std::size_t count, const Work& work) {
    std::atomic<std::size_t> next{0};
    const auto take = [&] {
        for (std::size_t i = next++; i < count; i = next++) work(i);
    };
    std::vector<std::jthread> workers;
    for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i) workers.emplace_back(take);
    take();
}

}  // namespace touchline::stability
