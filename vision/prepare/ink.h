// Finds what stands out from the paper it is drawn on, whatever the colours and however uneven the
// light.
// Threads: pure functions.
#pragma once

#include "vision/contour/gradient.h"

namespace touchline {

struct Ink {
    /// The difference of each pixel's colour from that of the paper there, grey levels.
    cv::Mat1f contrast;
    /// contrast over the contrast half-way to the ink around it: the edge of a stroke is the line
    /// where this is 1, even beside a darker stroke. Less than 1 everywhere if nothing stands out.
    cv::Mat1f darkness;
    /// darkness >= 1: 255, else 0.
    cv::Mat1b mask;
    /// A contrast below this is paper, grey levels.
    double floor = 0.0;
    /// The part of the picture in which the paper's colour is the commonest, by places: 0..1.
    double paper_part = 0.0;
};

/// Returns the least contrast of ink for the strongest one, grey levels: above grain, and above
/// dirt and shadow, which are faint beside ink.
[[nodiscard]] double least_contrast(double noise, double strongest);

/// Takes as paper the colour that most places share, which may change slowly across the picture (a
/// second-order surface, so a lamp's shade does no harm and no filled shape, however large, is
/// mistaken for shade). Paper may be dark: ink is what differs. Deterministic. O(pixels), about 25
/// ms a megapixel.
[[nodiscard]] Ink ink_of(const LabPicture& lab, double noise);

}  // namespace touchline
