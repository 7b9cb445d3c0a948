// Finds the lines of a picture in the way that suits its class.
#pragma once

#include "vision/contour/photo_lines.h"
#include "vision/prepare/picture_class.h"

#include <opencv2/core.hpp>

namespace touchline {

struct ClassLines {
    PictureClass picture_class = PictureClass::photo;  // the class whose way found them
    PhotoLines found;
};

/// photo: edges, and the main shape if one convinces; diagram: borders of flat colour; line art:
/// middle lines of strokes up to 6 mm wide; text page: a line through each line of text, and a box
/// around each figure (letters are not felt). If the way of its class finds nothing, or fifty times
/// more specks than lines, the picture is treated as a photo. For classes other than photo, `high`
/// is half the mean strength of the lines. `longer_side_mm`: how long the picture's longer side
/// will be at the handle. `figure`: the mask of a photo's main things (vision/figure), instead of
/// its main shape; empty: none. Throws cv::Exception without memory. Deterministic. Threads: pure
/// function. O(pixels).
[[nodiscard]] ClassLines class_lines(const cv::Mat& picture, PictureClass picture_class,
                                     double longer_side_mm, const cv::Mat1b& figure = {});

}  // namespace touchline
