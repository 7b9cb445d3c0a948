// Four corners in a picture. Pixels, the centre of the upper left pixel is (0, 0); clockwise as
// shown (y down). Threads: pure functions, O(1).
#pragma once

#include <array>
#include <optional>

#include <opencv2/core.hpp>

namespace touchline {

using Quad = std::array<cv::Point2d, 4>;

/// Returns the corners clockwise, beginning with the upper left one of the page as it lies: its top
/// side is the one whose middle is highest.
[[nodiscard]] Quad ordered(Quad quad);

[[nodiscard]] double area_of(const Quad& quad);

/// Returns true for a convex quad with no angle below 45 or above 135 degrees: a sheet seen from
/// above.
[[nodiscard]] bool is_sheet_like(const Quad& quad);

/// Returns the corners of the same place in the picture at another size.
[[nodiscard]] Quad rescaled(const Quad& quad, cv::Size from, cv::Size to);

struct Line {
    cv::Point2d point;
    cv::Point2d direction;  // unit
};

[[nodiscard]] Line line_through(cv::Point2d a, cv::Point2d b);

/// Returns nothing if they are nearly parallel (below 15 degrees).
[[nodiscard]] std::optional<cv::Point2d> crossing(const Line& a, const Line& b);

/// Returns the quad of four lines that follow each other round it; nothing if two neighbours do not
/// cross.
[[nodiscard]] std::optional<Quad> quad_of(const std::array<Line, 4>& sides);

}  // namespace touchline
