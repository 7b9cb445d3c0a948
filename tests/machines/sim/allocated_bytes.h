// How much heap memory a thread of a test program holds.
#pragma once

#include <cstdint>

namespace touchline {

/// Returns the bytes that malloc and its kin gave, as they round them, less what this thread freed.
/// Returns 0 under the address or thread sanitizer.
[[nodiscard]] std::int64_t allocated_bytes();

}  // namespace touchline
