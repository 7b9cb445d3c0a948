// A grey picture between two workers: width and height (u32 each), then its bytes. Nobody who reads
// it trusts it. Threads: pure functions.
#pragma once

#include "app/decode/picture.h"
#include "config/types/result.h"

#include <cstddef>
#include <span>
#include <vector>

namespace touchline {

[[nodiscard]] std::vector<std::byte> bytes_of(const GreyPicture& picture);

/// Fails unless the sizes are a picture's and fit the bytes.
[[nodiscard]] Result<GreyPicture> grey_of(std::span<const std::byte> bytes);

}  // namespace touchline
