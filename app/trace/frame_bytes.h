// A camera's frame in flat bytes, for the worker that makes a page of it: format u8, width i32,
// height i32 and bytes per row u64, then its bytes. Threads: pure functions.
#pragma once

#include "config/types/result.h"
#include "vision/camera/frame.h"

#include <cstddef>
#include <span>
#include <vector>

namespace touchline {

[[nodiscard]] std::vector<std::byte> bytes_of(const CameraFrame& frame);

/// Fails for an unknown format, for a size beyond app/decode/picture.h, and for a row that is
/// longer than all the bytes.
[[nodiscard]] Result<CameraFrame> frame_of(std::span<const std::byte> bytes);

}  // namespace touchline
