// The square marks at the corners of the stand's bed: the first four ArUco marks of 4 x 4 cells
// (dictionary DICT_4X4_50 of cv::aruco), which any program for such marks prints.
// S. Garrido-Jurado et al.: Automatic generation and detection of highly reliable fiducial markers
// (2014). Threads: pure functions.
#pragma once

#include "vision/prepare/quad.h"

#include <vector>

namespace touchline {

constexpr int fiducial_count = 4;

struct Fiducial {
    int id = 0;    // 0 ... fiducial_count - 1
    Quad corners;  // of the mark itself: its upper left, upper right, lower right, lower left
};

/// Each that is in the picture, once, by id; at least some 20 pixels large in a megapixel. One cell
/// may be misread. 8-bit BGR. O(pixels).
[[nodiscard]] std::vector<Fiducial> find_fiducials(const cv::Mat& bgr);

/// The mark as it is printed, without the bright margin that it needs around it: 6 x 6 cells.
[[nodiscard]] cv::Mat1b fiducial_drawing(int id, int cell_px);

}  // namespace touchline
