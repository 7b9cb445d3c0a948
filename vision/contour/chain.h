// An edge line in working pixels: the form that passes between linking, corners and ranking.
#pragma once

#include <vector>

#include <opencv2/core.hpp>

namespace touchline {

/// One point of an edge line. Pixel (column, row) has its centre at (column, row).
struct EdgePoint {
    cv::Point2d at;
    double strength = 0.0;  // grey levels per pixel
    bool is_fixed = false;  // a junction, a corner or an end: every later step keeps it exactly
    /// Unit vector across the line towards the lighter side (if the lightness is the same, the
    /// redder and yellower one); (0, 0) if that is not known.
    cv::Vec2f to_light{0.0F, 0.0F};
};

/// What a line shows: an edge or a stroke; the outline of many short lines; letters in a row; a
/// picture on a page of text; dashes or dots in a row; the main thing of a photograph, and what
/// lies behind it.
enum class LineOf { edge, texture, text, figure, dashed, dotted, ring, background };

/// If closed, the last point joins the first, which is not repeated.
struct Chain {
    std::vector<EdgePoint> points;
    bool is_closed = false;
    double width_px = 0;  // if the line stands for a drawn stroke; else 0
    LineOf of = LineOf::edge;
};

[[nodiscard]] inline double distance(const cv::Point2d& a, const cv::Point2d& b) {
    return cv::norm(a - b);
}

/// Returns the arc length in pixels; a closed chain's closing segment counts.
[[nodiscard]] inline double length_of(const Chain& chain) {
    double sum = 0.0;
    for (std::size_t i = 1; i < chain.points.size(); ++i) {
        sum += distance(chain.points[i - 1].at, chain.points[i].at);
    }
    return chain.is_closed && !chain.points.empty()
               ? sum + distance(chain.points.back().at, chain.points.front().at)
               : sum;
}

}  // namespace touchline
