// What networks see in a photograph: its main things, what they are taken for, its faces.
// Threads: pure functions (OpenCV uses its own inside).
#pragma once

#include "app/trace/main_things.h"
#include "app/trace/picture_networks.h"
#include "app/trace/place_in_picture.h"
#include "config/types/result.h"

#include <optional>

namespace touchline {

/// Looks at an 8-bit BGR picture, at all of it or for the thing at a place. Without the figure's
/// network, and where that is not sure, the people who are named are its main things. Fails, with
/// one line, where a network cannot be used. Some seconds.
[[nodiscard]] Result<MainThings> things_seen(const cv::Mat3b& picture,
                                             const PictureNetworks& networks,
                                             const std::optional<PlaceInPicture>& place);

}  // namespace touchline
