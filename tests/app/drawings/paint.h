// Drawings whose lines are known: what was painted, in which order, and which lines can be seen.
// Lengths are millimetres at the hand; (0, 0) is the upper left corner of the area.
// Threads: pure functions.
#pragma once

#include "tests/vision/pictures/canvas.h"

#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace touchline::testing {

/// The area of a 2diy gen 3, which every drawing has.
inline const cv::Size2d sheet_mm(116.0, 84.0);
/// A stroke up to this width is one line, along its middle; a wider one has two sides.
inline constexpr double widest_line_mm = 3.0;

/// One thing, painted over everything before.
struct Paint {
    std::vector<Polyline> lines;
    double width_mm = 0.0;  // stroke width; 0: filled
    bool is_even_odd = false;
    std::vector<double> dashes_mm = {};  // on and off; a broken stroke is felt whole
    cv::Scalar colour = {0, 0, 0};       // BGR
    double opacity = 1.0;
    std::vector<std::vector<Polyline>> clips = {};  // seen only inside all of them
};

struct Drawing {
    std::string kind;  // drawings of a kind share a difficulty
    std::string name;
    std::string file;  // as a visitor would bring it
    std::vector<Paint> paints;
    /// Areas that are not judged: texts, patterns.
    std::vector<cv::Rect2d> unjudged = {};
    bool has_words_in_pixels = false;  // the kiosk reads them before all is felt
};

/// A line that can be seen, in even steps of sample_step_mm or less.
struct SeenLine {
    std::vector<cv::Point2d> points;
    bool is_closed = false;
    bool is_border = false;  // of an area; otherwise the middle of a stroke
};

inline constexpr double sample_step_mm = 0.25;

/// Returns the middle of strokes up to widest_line_mm, or their one side that differs from what is
/// beside it, and the sides of areas and wider strokes; all only where the colours on both sides
/// differ. O(sheet + lines).
[[nodiscard]] std::vector<SeenLine> seen_lines(const Drawing& drawing);

}  // namespace touchline::testing
