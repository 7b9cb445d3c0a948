// Waits in real time for what another process or thread does. Threads: any.
#pragma once

#include <chrono>
#include <functional>

#include <poll.h>

namespace touchline {

/// Asks about every millisecond until the condition holds. Returns false if four minutes have
/// passed before: far longer than a busy machine needs, and shorter than a test may take.
[[nodiscard]] inline bool wait_until(const std::function<bool()>& condition) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(4);
    while (!condition()) {
        if (std::chrono::steady_clock::now() > end) return false;
        (void)poll(nullptr, 0, 1);
    }
    return true;
}

}  // namespace touchline
