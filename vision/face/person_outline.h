// The outline of the person with this face: hair or hat, neck, shoulders. Threads: pure function.
#pragma once

#include "vision/face/face_lines.h"

namespace touchline {

/// A part of a picture and a mask for it, stretched to any size: 128 and more is person.
struct PersonMask {
    cv::Mat1b mask;
    cv::Rect part;  // pixels of the picture, which holds the part
};

/// Returns the part of a picture that shows head and shoulders of a face, at the size that suits
/// the network for persons best. Empty if the face lies beside the picture.
[[nodiscard]] cv::Rect head_and_shoulders(const FaceMesh& mesh, cv::Size picture);

/// Returns the outline of the one person in the mask who has this face, all of which counts as
/// person. Pixels of the picture; one closed line, or open ones if the sides of the part cut it.
/// Returns none if the mask does not reach the face. Works on the part at 320 pixels: cut a larger
/// one to head_and_shoulders() first. O(pixels of the mask).
[[nodiscard]] std::vector<PartLine> person_outline(const PersonMask& person, const FaceMesh& mesh);

}  // namespace touchline
