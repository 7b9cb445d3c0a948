// A grey picture between two workers: width and height (u32 each), then its bytes. No reader trusts
// it. Threads: pure functions.
#pragma once

#include "app/decode/picture.h"
#include "config/types/result.h"

#include <cstddef>
#include <span>
#include <vector>

namespace touchline {

[[nodiscard]] std::vector<std::byte> bytes_of(const GreyPicture& picture);

/// Fails unless the size is valid for a picture and fits the bytes.
[[nodiscard]] Result<GreyPicture> grey_of(std::span<const std::byte> bytes);

}  // namespace touchline
