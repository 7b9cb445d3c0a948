// Letters and pictures of the DejaVu fonts, and how a camera might see them.
// Threads: pure functions.
#pragma once

#include "tests/vision/pictures/canvas.h"

#include <string>
#include <vector>

namespace touchline::testing {

/// Returns the outline of one character, `height_px` high or wide (whichever is larger), its middle
/// at `centre`; curves become lines, true to 0.05 px.
[[nodiscard]] std::vector<Polyline> glyph(const std::string& character, const Font& font,
                                          cv::Point2d centre, double height_px);

/// Returns sixteen letters, digits and signs with corners, counters, curves and thin parts.
[[nodiscard]] const std::vector<std::string>& letters();

/// Returns the pictures among DejaVu Sans's characters: telephone, aeroplane, umbrella, chess ...
[[nodiscard]] const std::vector<std::string>& picture_characters();

/// Pictogram `i` as a textured thing before a photo-like background, with another scene mirrored
/// over both, noise, and its boundary: pixels inside that have a neighbour outside.
struct TruthScene {
    cv::Mat picture;     // 8-bit BGR
    cv::Mat1b boundary;  // 255 on the boundary
};

[[nodiscard]] TruthScene pictogram_scene(int i, cv::Size size);

}  // namespace touchline::testing
