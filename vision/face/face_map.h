// A face as a map of its own, as large as the area allows. Threads: pure function.
#pragma once

#include "config/types/tactile_map.h"
#include "vision/face/face_lines.h"

#include <vector>

namespace touchline {

struct FaceMap {
    TactileMap map;
    std::vector<FacePart> parts;  // of each outline; their labels are set by the caller
    cv::Rect2d shown;             // what of the picture fills the area, pixels; may reach beyond it
};

/// The head with the beginning of the shoulders. `face`: the box of its mesh; `lines`: of face and
/// person, pixels. Detail 1 has outline and oval, 2 eyes and mouth as well, 3 nose and brows, 4 the
/// nostrils. Outlines lie in the area, cross neither themselves nor one another and are 3.2 mm
/// apart, or two places of one that are four times as far apart along it; but the oval's ends meet
/// the person's outline where it would run along it. An eye or mouth that is open is opened as far
/// as a finger needs. Brows and nostrils are moved up or down, eyes and mouth across the face, by
/// 3 mm at most, where they are too near to what is there; an eye or mouth that then has no room as
/// a ring is one line; of a line without room the rest stays, or nothing, where that is little. Ids
/// "outline-1" ..., the most important first. No outlines, where the box is none. O(points x points
/// near).
[[nodiscard]] FaceMap face_map(const cv::Rect2d& face, const std::vector<PartLine>& lines,
                               const Area& area);

}  // namespace touchline
