// Strokes made up at random: broken into dashes or dots, and of all widths across each other.
// Threads: pure functions.
#pragma once

#include "tests/app/drawings/paint.h"

#include <span>
#include <vector>

namespace touchline::testing {

/// How a line is broken. Lengths in millimetres of ink and of paper between it.
struct Dashing {
    double dash_mm = 3.0;  // 0: dots
    double gap_mm = 2.0;
    double width_mm = 0.6;
    bool is_round = false;  // its caps, and so its dots
    cv::Scalar colour = {0, 0, 0};
};

/// Short and long dashes, thin and thick ones, round and square dots.
[[nodiscard]] std::span<const Dashing> dashings();

/// A straight line, an arc, a wave and a polygon broken like this, beside two filled areas; the
/// same for the same seed: an SVG. Dots' gaps and dashes' are of paper: round caps are not gaps.
[[nodiscard]] Drawing dashed_drawing(const Dashing& dashing, int seed);

/// Line art that is broken lines alone, or but for a box beside: a box of dashes, a circle of dots,
/// a circle of dashes, a dashed axis below a whole box; an SVG.
[[nodiscard]] std::vector<Drawing> broken_line_art();

/// What a program makes of strokes that it traced: a ring and a frame, each filled between two
/// outlines this far apart; an SVG. Without the even-odd rule the inner outlines run the other way.
[[nodiscard]] Drawing thin_fills(double width_mm, bool is_even_odd);

/// Strokes 0.5 to 6 mm wide, straight, bent and waved, that cross each other, all black or each of
/// its own colour; the same for the same seed: an SVG.
[[nodiscard]] Drawing crossing_strokes(int seed);

}  // namespace touchline::testing
