// Work that waits, on a thread beside the screen's. Threads: any.
#pragma once

#include <exception>
#include <future>
#include <type_traits>
#include <utility>

namespace touchline {

/// Begins the work, and returns its end to be, which waits for its thread when it goes. The end is
/// `failed` if the machine has no thread left, or no memory for the work: the kiosk goes on.
template <class Work>
[[nodiscard]] auto on_own_thread(Work work, std::invoke_result_t<Work&> failed) {
    using End = std::invoke_result_t<Work&>;
    try {
        return std::async(std::launch::async, [work = std::move(work), failed]() mutable -> End {
            try {
                return work();
            } catch (const std::exception&) {
                return std::move(failed);
            }
        });
    } catch (const std::exception&) {
        std::promise<End> answer;
        answer.set_value(std::move(failed));
        return answer.get_future();
    }
}

}  // namespace touchline
