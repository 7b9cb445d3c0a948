// A face as a map of its own, as large as the area allows. Eyes and mouths are rings with two
// corners, whose sides are near each other.
// Threads: pure functions.
#pragma once

#include "config/types/tactile_map.h"
#include "vision/face/face_lines.h"
#include "vision/simplify/spacing.h"

#include <vector>

namespace touchline {

/// Returns a ring in millimetres with its sides as far apart as a finger needs to find two lines:
/// at least 3.6 mm in the middle, and as much more, up to 6 mm, as keeps it from coming too near to
/// itself. A ring without two fixed points, or without width, stays as it is. O(points x points
/// near).
[[nodiscard]] Chain opened_for_finger(const Chain& ring, const SpacingScale& scale);

/// Returns the line halfway between its sides, from corner to corner. A ring without two fixed
/// points stays as it is. O(points).
[[nodiscard]] Chain middle_of(const Chain& ring);

struct FaceMap {
    TactileMap map;
    std::vector<FacePart> parts;  // for each outline; the caller sets their labels
    cv::Rect2d shown;  // part of the picture that fills the area, pixels; may reach beyond it
};

/// Draws the head with the beginning of the shoulders. `face`: the box of its mesh; `lines`: the
/// face's and the person's, pixels. Detail 1 has the outline and the oval, 2 also eyes and mouth, 3
/// nose and brows, 4 the nostrils. Outlines lie in the area, cross neither themselves nor one
/// another and are 3.2 mm apart, as are two places of one outline that are four times as far apart
/// along it; but the oval's ends meet the person's outline where it would run along it. An open eye
/// or mouth is opened as far as a finger needs. If they are too near to what is there, brows and
/// nostrils are moved up or down, and eyes and mouth across the face, by at most 3 mm. An eye or
/// mouth that then has no room as a ring is one line; of a line without room the rest stays, or
/// nothing if that is little. Ids "outline-1" ..., the most important first. No outlines if the box
/// is invalid. O(points x points near).
[[nodiscard]] FaceMap face_map(const cv::Rect2d& face, const std::vector<PartLine>& lines,
                               const Area& area);

}  // namespace touchline
