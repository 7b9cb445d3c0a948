// From pixels to the drawing area and to maps: all of a picture, or a part of it enlarged, fills
// the area.
// Threads: values and pure functions.
#pragma once

#include "config/types/map_frame.h"
#include "config/types/tactile_map.h"
#include "vision/contour/chain.h"

#include <algorithm>
#include <vector>

#include <opencv2/core.hpp>

namespace touchline {

/// Centres the whole picture in the area, as large as fits, aspect kept; row down = W y down.
class Placement {
  public:
    Placement(cv::Size picture, cv::Size working, const Area& area)
        : mm_per_pixel_(1000.0 *
                        std::min(area.width_m / picture.width, area.height_m / picture.height)),
          mm_per_column_(mm_per_pixel_ * picture.width / working.width),
          mm_per_row_(mm_per_pixel_ * picture.height / working.height),
          left_mm_(500.0 * area.width_m - 0.5 * mm_per_pixel_ * picture.width),
          top_mm_(500.0 * area.height_m - 0.5 * mm_per_pixel_ * picture.height) {}

    double picture_pixels_per_metre() const { return 1000.0 / mm_per_pixel_; }

    double metres_per_working_pixel() const { return 0.5e-3 * (mm_per_column_ + mm_per_row_); }

    /// Converts a place in working pixels to millimetres of the viewBox, x right, y down.
    cv::Point2d in_mm(cv::Point2d at) const {
        return {left_mm_ + (at.x + 0.5) * mm_per_column_, top_mm_ + (at.y + 0.5) * mm_per_row_};
    }

  private:
    double mm_per_pixel_;
    double mm_per_column_;
    double mm_per_row_;
    double left_mm_;
    double top_mm_;
};

/// The part of the area around `centre` (W of the whole picture) that is enlarged `factor` times so
/// that it fills the area. The default shows the whole picture.
struct Zoom {
    Position centre;
    double factor = 1.0;  // 1 ... 16

    friend bool operator==(const Zoom&, const Zoom&) = default;
};

/// Moves the points of a line in millimetres of the viewBox that lie beyond the area to its rim.
/// O(points).
[[nodiscard]] Chain within(Chain line, cv::Size2d area_mm);

/// Converts lines in working pixels to millimetres of the viewBox. Clips them by the area if it is
/// enlarged; else moves them within() it, because a corner may be found a little beyond the
/// picture. Cut ends are exactly on the area's rim, and fixed. A closed line that is cut becomes
/// open parts. O(points).
[[nodiscard]] std::vector<Chain> in_zoom(const std::vector<Chain>& lines,
                                         const Placement& placement, const Area& area,
                                         const Zoom& zoom);

/// Returns where the picture itself then lies, millimetres of the viewBox.
[[nodiscard]] cv::Rect2d picture_in_zoom(const Placement& placement, cv::Size working,
                                         const Area& area, const Zoom& zoom);

/// Returns a map of the whole picture as it is felt enlarged: clips outlines by the area and leaves
/// out labels outside it. Leaves out parts of less than a millimetre; the others of an outline keep
/// its id with a number behind it. Factor 1 changes nothing. O(points).
[[nodiscard]] TactileMap enlarged(const TactileMap& map, const Zoom& zoom);

/// Returns only the labels of such a map.
[[nodiscard]] std::vector<Label> enlarged(const std::vector<Label>& labels, const Area& area,
                                          const Zoom& zoom);

/// Converts a line in millimetres of the viewBox, with each place on the map's grid only once. A
/// closed line must have points. O(points).
[[nodiscard]] inline Outline outline_of(const Chain& line, const Area& area) {
    Outline outline;
    outline.is_closed = line.is_closed;
    for (const EdgePoint& point : line.points) {
        const Position p = canonical_point(point.at.x, point.at.y, area);
        if (outline.points.empty() || !(outline.points.back() == p)) outline.points.push_back(p);
    }
    if (outline.is_closed && outline.points.front() == outline.points.back()) {
        outline.points.pop_back();
    }
    return outline;
}

}  // namespace touchline
