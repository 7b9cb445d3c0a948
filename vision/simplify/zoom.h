// What of a picture fills the drawing area: all of it, or a part of it enlarged.
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

/// A line in millimetres of the viewBox whose points beyond the area lie on its rim instead.
/// O(points).
[[nodiscard]] Chain within(Chain line, cv::Size2d area_mm);

/// Lines in working pixels to millimetres of the viewBox, clipped by the area where it is
/// enlarged, else within() it: a corner may be found a little beyond the picture. Cut ends are
/// exactly on its rim, and fixed. A closed line that is cut comes out in
/// open parts. O(points).
[[nodiscard]] std::vector<Chain> in_zoom(const std::vector<Chain>& lines,
                                         const Placement& placement, const Area& area,
                                         const Zoom& zoom);

/// Where the picture itself lies then, millimetres of the viewBox.
[[nodiscard]] cv::Rect2d picture_in_zoom(const Placement& placement, cv::Size working,
                                         const Area& area, const Zoom& zoom);

/// A map of the whole picture as it is felt enlarged: outlines clipped by the area, labels that lie
/// outside it left out. Parts of less than a millimetre are left out; the others of an outline keep
/// its id with a number behind it. Factor 1 changes nothing. O(points).
[[nodiscard]] TactileMap enlarged(const TactileMap& map, const Zoom& zoom);

/// The labels of such a map alone.
[[nodiscard]] std::vector<Label> enlarged(const std::vector<Label>& labels, const Area& area,
                                          const Zoom& zoom);

}  // namespace touchline
