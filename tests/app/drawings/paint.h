// Drawings whose lines are known: what was painted, in which order, and which lines of it can be
// seen. Lengths are millimetres at the hand, (0, 0) the upper left corner of the area. Threads:
// pure functions.
#pragma once

#include "tests/vision/pictures/canvas.h"

#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace touchline::testing {

/// The area of a 2diy gen 3, that of every drawing.
inline const cv::Size2d kSheet_mm(116.0, 84.0);
/// A stroke up to this width is one line, along its middle; a wider one has two sides.
inline constexpr double kWidestLine_mm = 3.0;

/// One thing painted over what was painted before.
struct Paint {
    std::vector<Polyline> lines;
    double width_mm = 0.0;  // of a stroke; 0: filled
    bool is_even_odd = false;
    std::vector<double> dashes_mm = {};  // on and off; a stroke that is broken is felt whole
    cv::Scalar colour = {0, 0, 0};       // BGR
    double opacity = 1.0;
    std::vector<std::vector<Polyline>> clips = {};  // seen inside all of them only
};

struct Drawing {
    std::string kind;  // of drawings that share a difficulty
    std::string name;
    std::string file;  // the bytes that a visitor would bring
    std::vector<Paint> paints;
    /// Areas of which nothing is asked: texts, patterns.
    std::vector<cv::Rect2d> unjudged = {};
    bool has_words_in_pixels = false;  // that the kiosk reads before all is felt
};

/// A line that can be seen, in even steps of kStep_mm or less.
struct SeenLine {
    std::vector<cv::Point2d> points;
    bool is_closed = false;
    bool is_border = false;  // of an area, else the middle of a stroke
};

inline constexpr double kStep_mm = 0.25;

/// Of a stroke up to kWidestLine_mm the middle, or the one side of it that differs from what is
/// beside it; of areas and wider strokes the sides; of all these where the colours on both sides
/// differ. O(sheet + lines).
[[nodiscard]] std::vector<SeenLine> seen_lines(const Drawing& drawing);

}  // namespace touchline::testing
