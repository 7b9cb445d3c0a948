// What a thread of a test program holds of the heap.
#pragma once

#include <cstdint>

namespace touchline {

/// By malloc and its kin, as they round it, less what this thread freed. 0 under a sanitizer of
/// addresses or threads.
[[nodiscard]] std::int64_t allocated_bytes();

}  // namespace touchline
