// A photograph's main things, from the likelihood that a network gives each place; and its lines
// with them: a ring round each, what lies in it, and what lies behind it.
// Threads: pure functions.
#pragma once

#include "vision/contour/photo_lines.h"

#include <vector>

#include <opencv2/core.hpp>

namespace touchline {

/// The input of the rule of sureness, 0..1: how much of the picture is figure; and by how much the
/// likelihood a little inside its edge is greater than a little outside.
struct FigureSigns {
    double area = 0.0;
    double contrast = 0.0;
};

/// The figures of one picture, all in one mask.
struct Figures {
    cv::Mat1b mask;               // of the picture's proportions; 128 and more: figure; soft edges
    std::vector<cv::Rect> boxes;  // in the mask, of each figure, the largest first
    FigureSigns signs;
    bool is_sure = false;  // if false, a visitor is told that there is no clear main thing
};

/// `likelihood`: 0..1 over the whole picture, stretched to a square or not; `picture`: its size. A
/// place is figure from a likelihood of 0.3 on. A part counts from 5 % of all of them and 0.2 % of
/// the picture on; a hole in it counts from 0.4 % of the picture on, and smaller ones are filled.
/// The mask has at most a megapixel. The result is sure from a contrast of 0.67 on, and from 0.3 %
/// of the picture on. Without figures there are no boxes. O(pixels).
[[nodiscard]] Figures figures_of(const cv::Mat1f& likelihood, cv::Size picture);

/// Returns the part of a picture in which to look for the thing at a place: a square of that share
/// of the longer side round it, moved and cut so that it lies in the picture. O(1).
[[nodiscard]] cv::Rect part_around(cv::Size picture, cv::Point place, double share);

/// Finds the thing at a place, by the likelihood over a part of the picture that holds it: the one
/// that lies there, or within a twentieth of the part's longer side. Not sure if the part shows
/// none, cuts it, or is filled by it, as by a ground. O(pixels).
[[nodiscard]] Figures figure_at(const cv::Mat1f& likelihood, const cv::Rect& part, cv::Size picture,
                                cv::Point place);

/// Adds to a photo's lines (of `picture`, 8-bit BGR or grey) the rings of a mask of the same
/// proportions (128 and more: figure), each drawn onto the strongest edge within a millimetre:
/// LineOf::ring, for holes too, as strong as the strongest line, open where the picture's
/// frame cuts the figure. Lines in the figure, 3.2 mm and more from its rings, stay as they are;
/// lines as far outside become LineOf::background; lines along a ring go. Changes nothing if no
/// place of the mask has 128. O(pixels).
[[nodiscard]] PhotoLines with_figure(PhotoLines lines, const cv::Mat& picture,
                                     const cv::Mat1b& mask, double longer_side_mm);

}  // namespace touchline
