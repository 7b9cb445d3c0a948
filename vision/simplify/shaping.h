// Shapes one line at the scale of a detail: smooths away what is finer than a hand should meet,
// keeps the corners that make the shape, and takes it apart where it crosses itself. Chains here
// are in millimetres.
// Threads: pure functions.
#pragma once

#include "vision/contour/chain.h"

#include <vector>

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

/// Returns the line as parts that do not cross themselves: each loop that a crossing closes becomes
/// a closed line of its own (with a fixed point where it was cut off), and the rest goes on through
/// the crossing. Drops parts of crossing lines shorter than `least_mm`; perhaps none is left.
/// O(points) per cut.
[[nodiscard]] std::vector<Chain> without_self_crossings(const Chain& line, double least_mm);

/// Returns whether the line will cross itself once its points are on the grid of a map: a line that
/// leads back along itself may do so only there. False if it only touches itself. O(points).
[[nodiscard]] bool crosses_itself_in_map(const Chain& line);

/// Returns the line as parts that do not cross themselves there. O(points) per cut.
[[nodiscard]] std::vector<Chain> without_crossings_in_map(const Chain& line);

}  // namespace touchline
