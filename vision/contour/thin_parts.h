// Which areas of a map of colours are strokes.
// Threads: pure function (OpenCV uses its own inside).
#pragma once

#include <opencv2/core.hpp>

namespace touchline {

struct ThinParts {
    cv::Mat1b strokes;  // 255 inside, of all colours together: they may cross
    cv::Mat1b map;      // of what is left, grown over the strokes
};

/// The map has no specks. What of each colour's areas is no wider than a stroke (ink_parts.h). Of
/// the ground, the commonest colour, only what is so as a whole: between two shapes it is a gap,
/// within one a line. Strokes of several colours side by side that are wide together are no
/// strokes. O(pixels x colours).
[[nodiscard]] ThinParts thin_parts_of(const cv::Mat1b& map, double greatest_width_px);

}  // namespace touchline
