// The part of a picture that fills the drawing area: all of it, or a part of it enlarged.
// Threads: values and pure functions.
#pragma once

#include "config/types/tactile_map.h"
#include "vision/contour/chain.h"
#include "vision/simplify/placement.h"

#include <vector>

namespace touchline {

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

}  // namespace touchline
