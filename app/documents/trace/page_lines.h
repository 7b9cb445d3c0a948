// Finds the lines of a page that another worker answered: the worker's side, directly on the bytes.
// Threads: pure functions.
#pragma once

#include "app/documents/decode/page.h"
#include "config/types/result.h"
#include "vision/simplify/trace.h"

#include <cstddef>
#include <span>

#include <opencv2/core.hpp>

namespace touchline {

/// `page` comes from answer_of() of app/documents/decode/page.h. Paints words over in the colour
/// around them, because letters are heard, not felt. Fails as page_of() and find_lines() do.
/// O(pixels); copies the pixels only if there are words.
[[nodiscard]] Result<Found> find_lines_of_page(std::span<const std::byte> page,
                                               const TraceOptions& options,
                                               const cv::Mat1b& main_things = {});

/// A view of read-only pixels: give it only to what takes a constant matrix.
[[nodiscard]] cv::Mat view_of(const decode::AnswerParts& page);

}  // namespace touchline
