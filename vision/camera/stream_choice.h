// Which of the modes that a camera offers are taken. Threads: pure functions, O(modes).
#pragma once

#include "vision/camera/camera_port.h"

namespace touchline {

/// The smallest mode that is at least 640 x 480, else the largest; of one size nv12 before yuyv
/// before mjpeg, which costs decoding. Nothing when there is no mode.
[[nodiscard]] std::optional<StreamMode> preview_mode(const CameraAbilities& abilities);

/// The largest mode; of one size mjpeg last.
[[nodiscard]] std::optional<StreamMode> still_mode(const CameraAbilities& abilities);

}  // namespace touchline
