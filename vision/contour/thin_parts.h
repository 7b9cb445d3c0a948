// Finds which areas of a map of colours are strokes.
// Threads: pure function (OpenCV uses its own inside).
#pragma once

#include <opencv2/core.hpp>

namespace touchline {

struct ThinParts {
    cv::Mat1b strokes;  // 255 inside, for all colours together: they may cross
    cv::Mat1b map;      // of the rest, grown over the strokes
};

/// The map has no specks. Strokes are the parts of each colour's areas that are no wider than a
/// stroke (ink_parts.h). Of the ground, the commonest colour, only areas that are thin as a whole
/// count: between two shapes such an area is a gap, within one a line. Strokes of several colours
/// side by side that are wide together are not strokes. O(pixels x colours).
[[nodiscard]] ThinParts thin_parts_of(const cv::Mat1b& map, double greatest_width_px);

}  // namespace touchline
