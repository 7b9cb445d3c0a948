// Four corners in a picture, and the page between them as seen from above. Pixels, the centre of
// the upper left pixel is (0, 0); clockwise as shown (y down).
// Threads: pure functions, O(1) where nothing else is said.
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

constexpr double a4_aspect = 297.0 / 210.0;
constexpr double letter_aspect = 11.0 / 8.5;

/// The assumed focal length, as a share of the picture's longer side: 58 degrees across.
constexpr double usual_focal_share = 0.9;

/// Returns width over height of the rectangle whose picture is this quad, from its perspective. The
/// camera's focal length comes from the quad itself if it is aslant enough to tell; otherwise the
/// usual one is assumed, which then hardly matters. The lens looks through the middle of the
/// picture. O(1). Z. Zhang, L.-W. He: Whiteboard scanning (2007).
[[nodiscard]] double aspect_of(const Quad& corners, cv::Size picture);

/// Returns that of A4 or Letter, upright or lying, if the aspect is within 3 % of it; else as it
/// is.
[[nodiscard]] double snapped_aspect(double aspect);

/// Returns 8-bit BGR, width / height = aspect, at most `most_pixels` and never more than the quad
/// has in the picture. O(pixels).
[[nodiscard]] cv::Mat rectified(const cv::Mat& bgr, const Quad& corners, double aspect,
                                double most_pixels = 1e6);

}  // namespace touchline
