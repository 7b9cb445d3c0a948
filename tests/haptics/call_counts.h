// Counts the allocations and locks of a program that links this: malloc and its kin, operator new,
// and the locks of pthread are replaced by ones that count and pass on. Under the sanitizers, which
// bring their own, only operator new is counted. Threads: each counts its own.
#pragma once

#include <cstdint>

namespace touchline {

struct CallCounts {
    std::uint64_t allocations = 0;  // and releases
    std::uint64_t locks = 0;
};

/// Counting is on while one lives.
class CallCounter {
  public:
    CallCounter();
    ~CallCounter();
    CallCounter(const CallCounter&) = delete;
    CallCounter& operator=(const CallCounter&) = delete;
};

/// What was counted since the last time this was asked.
[[nodiscard]] CallCounts take_call_counts();

}  // namespace touchline
