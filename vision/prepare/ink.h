// What stands out from the paper that it is drawn on, whatever the colours and however uneven the
// light.
// Threads: pure functions.
#pragma once

#include "vision/contour/gradient.h"

namespace touchline {

struct Ink {
    /// How far each pixel's colour is from that of the paper there, grey levels.
    cv::Mat1f contrast;
    /// contrast over what half-way to the ink around it would be: the edge of a stroke is the line
    /// where this is 1, also beside a darker stroke; less than 1 everywhere where nothing stands
    /// out.
    cv::Mat1f darkness;
    /// darkness >= 1: 255, else 0.
    cv::Mat1b mask;
    /// Contrast below this is paper, grey levels.
    double floor = 0.0;
    /// Part of the picture in which the paper's colour is the commonest, by places: 0..1.
    double paper_part = 0.0;
};

/// Contrast that is ink where the strongest is known, grey levels: more than grain, and than dirt
/// and shadow, which are faint beside ink.
[[nodiscard]] double least_contrast(double noise, double strongest);

/// The paper is the colour that most places share, allowed to change slowly across the picture (a
/// second-order surface, so a lamp's shade costs nothing and no filled shape, however large, is
/// mistaken for shade). It may be dark: ink is what differs. Deterministic. O(pixels), about 25 ms
/// a megapixel.
[[nodiscard]] Ink ink_of(const LabPicture& lab, double noise);

}  // namespace touchline
