// A photograph of what lies under the camera becomes a page: the worker's side.
// Threads: pure function.
#pragma once

#include "app/decode/page.h"
#include "app/trace/photo_cut.h"
#include "vision/camera/frame.h"

namespace touchline {

/// The page that was laid down, without the shade of the lamp; where no page is found, the
/// photograph as it is. Fails with one sentence that says what keeps it from being used (too dark,
/// a page that is cut off). O(pixels).
[[nodiscard]] Result<Page> photo_page(const CameraFrame& frame, const PhotoCut& cut);

}  // namespace touchline
