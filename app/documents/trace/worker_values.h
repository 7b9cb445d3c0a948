// What crosses between workers as flat bytes, little-endian. No reader trusts it.
//
//   camera's frame  for the worker that makes a page of it: format u8, width i32, height i32 and
//                   bytes per row u64, then its bytes
//   grey picture    width and height (u32 each), then its bytes
//   found lines     for another worker, the same program, that makes a map of them: what was found,
//                   then each chain with its points; the kiosk keeps them and does not look inside
//
// Threads: pure functions.
#pragma once

#include "app/documents/decode/picture.h"
#include "config/types/result.h"
#include "vision/camera/frame.h"
#include "vision/simplify/trace.h"

#include <cstddef>
#include <span>
#include <vector>

namespace touchline {

[[nodiscard]] std::vector<std::byte> bytes_of(const CameraFrame& frame);

/// Fails for an unknown format, for a size beyond app/documents/decode/picture.h, and for a row
/// that is longer than all the bytes.
[[nodiscard]] Result<CameraFrame> frame_of(std::span<const std::byte> bytes);

[[nodiscard]] std::vector<std::byte> bytes_of(const GreyPicture& picture);

/// Fails unless the size is valid for a picture and fits the bytes.
[[nodiscard]] Result<GreyPicture> grey_of(std::span<const std::byte> bytes);

/// Holds what trace_lines() needs, and the report; leaves out the edges' strengths and the features
/// of the class. O(points).
[[nodiscard]] std::vector<std::byte> bytes_of(const Found& found);

/// Restores what bytes_of() got, bit for bit. Fails unless the sizes add up, every number is finite
/// and no size of a picture is empty. O(points).
[[nodiscard]] Result<Found> found_of(std::span<const std::byte> bytes);

}  // namespace touchline
