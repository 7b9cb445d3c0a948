// How much memory the computer has left. Threads: any.
#pragma once

#include <cstdint>

namespace touchline {

/// What programs can still take without others losing theirs; all there is, where the system does
/// not tell.
[[nodiscard]] std::uint64_t free_memory_bytes();

}  // namespace touchline
