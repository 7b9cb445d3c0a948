// The pixels of a worker's answer as an OpenCV matrix. Threads: pure function.
#pragma once

#include "app/decode/answer_parts.h"

#include <opencv2/core.hpp>

namespace touchline {

/// A view of read-only pixels: give it only to what takes a constant matrix.
[[nodiscard]] cv::Mat view_of(const decode::AnswerParts& page);

}  // namespace touchline
