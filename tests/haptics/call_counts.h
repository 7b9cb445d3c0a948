// Counts the allocations and locks of a program that links this. It replaces malloc and its kin,
// operator new, and the locks of pthread by functions that count and pass on. Under the sanitizers,
// which bring their own, it counts only operator new. Threads: each counts its own.
#pragma once

#include "config/types/pinned.h"

#include <cstdint>

namespace touchline {

struct CallCounts {
    std::uint64_t allocations = 0;  // and releases
    std::uint64_t locks = 0;
};

/// Counts as long as it lives.
class CallCounter : private Pinned {
  public:
    CallCounter();
    ~CallCounter();
};

/// Returns what was counted since the last call.
[[nodiscard]] CallCounts take_call_counts();

}  // namespace touchline
