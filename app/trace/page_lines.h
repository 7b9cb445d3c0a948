// The lines of a page as a worker answers it: the worker's side, on the bytes as they lie there.
// Threads: pure functions.
#pragma once

#include "config/types/result.h"
#include "vision/simplify/trace.h"

#include <cstddef>
#include <span>

#include <opencv2/core.hpp>

namespace touchline {

/// `page` is what answer_of() of app/decode/page.h gives. Words are painted over in the colour
/// around them: letters are heard, not felt. Fails as page_of() and find_lines() do. O(pixels); the
/// pixels are copied only where there are words.
[[nodiscard]] Result<Found> find_lines_of_page(std::span<const std::byte> page,
                                               const TraceOptions& options,
                                               const cv::Mat1b& main_things = {});

}  // namespace touchline
