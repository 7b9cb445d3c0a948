// The pixels of a worker's answer as OpenCV takes them. Threads: pure function.
#pragma once

#include "app/decode/answer_parts.h"

#include <opencv2/core.hpp>

namespace touchline {

/// A view of pixels that nobody may write to: only what takes a constant matrix may be given it.
[[nodiscard]] cv::Mat view_of(const decode::AnswerParts& page);

}  // namespace touchline
