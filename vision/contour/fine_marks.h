// Marks on the areas of a flat picture that are too small for an area of their own: hair lines,
// dashes, dots.
// Threads: pure function.
#pragma once

#include "vision/contour/gradient.h"

#include <vector>

namespace touchline {

struct FineMarks {
    cv::Mat1b lines;     // 255 inside: long, or parts of the known strokes
    cv::Mat1b bits;      // all others: dashes, dots, letters
    cv::Mat1f contrast;  // to the area around, grey levels
};

/// An area's colours, without its strokes.
struct Areas {
    const cv::Mat1b& map;
    const std::vector<cv::Vec3f>& palette;
};

/// Finds thin pixels of a picture that differ from their area clearly and abruptly. `strokes` are
/// the ones already known; `smoothing_px` is the picture's smoothing. O(pixels).
[[nodiscard]] FineMarks fine_marks(const LabPicture& lab, const Areas& areas,
                                   const cv::Mat1b& strokes, double noise, double smoothing_px,
                                   double greatest_width_px);

}  // namespace touchline
