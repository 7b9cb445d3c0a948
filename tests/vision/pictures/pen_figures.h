// Random figures drawn with a pen: corners from 15 degrees on, crossings, joints; and how lines
// connect. Threads: pure functions.
#pragma once

#include "tests/vision/pictures/canvas.h"

#include <string>
#include <vector>

namespace touchline::testing {

/// Lines share a point exactly where they meet.
struct PenFigure {
    std::string name;
    std::vector<Polyline> lines;
    Pen pen;
};

/// Draws a figure on a picture of this size, the same for the same seed: polygons, stars, zig-zags,
/// arrows, crossings, joints of three strokes, strokes that end on another, letters of straight
/// strokes. Pens of 2.5 to 8 pixels, all joins and caps; sides of 14 pens or more at the sharpest
/// corners.
[[nodiscard]] PenFigure pen_figure(int seed, cv::Size size);

/// How lines that share points exactly connect.
struct Topology {
    int parts = 0;
    int loops = 0;
    int ends = 0;
    std::vector<int> junctions;  // the number of lines that leave each, three or more, least first

    friend bool operator==(const Topology&, const Topology&) = default;
};

[[nodiscard]] Topology topology_of(const std::vector<Polyline>& lines);

[[nodiscard]] std::string words_of(const Topology& topology);

}  // namespace touchline::testing
