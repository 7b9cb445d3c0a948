// Chooses among the modes that a camera offers. Threads: pure functions, O(modes).
#pragma once

#include "vision/camera/camera_port.h"

namespace touchline {

/// Returns the smallest mode that is at least 640 x 480, else the largest. Among modes of one size
/// it prefers nv12 to yuyv, and yuyv to mjpeg, which costs decoding. Returns nothing if there is no
/// mode.
[[nodiscard]] std::optional<StreamMode> preview_mode(const CameraAbilities& abilities);

/// Returns the largest mode; among modes of one size, mjpeg comes last.
[[nodiscard]] std::optional<StreamMode> still_mode(const CameraAbilities& abilities);

}  // namespace touchline
