// Random strokes: broken into dashes or dots, and of all widths across each other.
// Threads: pure functions.
#pragma once

#include "tests/app/drawings/paint.h"

#include <span>
#include <vector>

namespace touchline::testing {

/// How a line is broken: lengths of ink, and of paper between, in millimetres.
struct Dashing {
    double dash_mm = 3.0;  // 0: dots
    double gap_mm = 2.0;
    double width_mm = 0.6;
    bool is_round = false;  // round caps, or round dots
    cv::Scalar colour = {0, 0, 0};
};

/// Returns short and long dashes, thin and thick ones, round and square dots.
[[nodiscard]] std::span<const Dashing> dashings();

/// Returns an SVG: a straight line, an arc, a wave and a polygon broken in this way, beside two
/// filled areas; the same for the same seed. Gaps of dots and dashes are of paper: round caps do
/// not count as gap.
[[nodiscard]] Drawing dashed_drawing(const Dashing& dashing, int seed);

/// Returns SVGs of line art made only of broken lines, or with one box beside them: a box of
/// dashes, a circle of dots, a circle of dashes, a dashed axis below a whole box.
[[nodiscard]] std::vector<Drawing> broken_line_art();

/// Returns an SVG as a program makes it of strokes that it traced: a ring and a frame, each filled
/// between two outlines this far apart. Without the even-odd rule the inner outlines run the other
/// way.
[[nodiscard]] Drawing thin_fills(double width_mm, bool is_even_odd);

/// Returns an SVG of strokes 0.5 to 6 mm wide, straight, bent and waved, that cross each other, all
/// black or each in its own colour; the same for the same seed.
[[nodiscard]] Drawing crossing_strokes(int seed);

}  // namespace touchline::testing
