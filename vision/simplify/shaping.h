// Shapes one line at the scale of a detail: smooths away what is finer than a hand should meet, and
// keeps the corners that make the shape. Chains here are in millimetres.
// Threads: pure functions.
#pragma once

#include "vision/contour/chain.h"

namespace touchline {

struct ShapingScale {
    double step_mm = 0.25;          // between points
    double tolerance_mm = 0.0;      // Gaussian sigma along the line
    double least_feature_mm = 0.0;  // a corner is judged by the course over half of it each way
};

/// Returns the line with even points. A fixed point inside it stays, exactly, if the course over
/// half a feature before and after turns by more than 40 degrees and no sharper one is nearer than
/// a quarter of a feature; between two of them the line is smoothed. Ends stay. Smooth curves stay
/// smooth: a circle of radius R shrinks by tolerance^2 / 2R. O(points x tolerance / step).
[[nodiscard]] Chain shaped(const Chain& line, const ShapingScale& scale);

}  // namespace touchline
