// The outline of the person whose face it is: hair or hat, neck, shoulders. Threads: pure function.
#pragma once

#include "vision/face/face_lines.h"

namespace touchline {

/// A part of a picture and a mask that stands for it, stretched to any size: 128 and more: person.
struct PersonMask {
    cv::Mat1b mask;
    cv::Rect part;  // pixels of the picture, which holds it
};

/// The part of a picture that shows head and shoulders of a face, as the network for persons sees
/// them best. Empty where the face lies beside the picture.
[[nodiscard]] cv::Rect head_and_shoulders(const FaceMesh& mesh, cv::Size picture);

/// The outline of the one person in the mask who has this face, all of which counts as person.
/// Pixels of the picture; one closed line, or open ones where the sides of the part cut it. None,
/// where the mask does not reach the face. The part is worked on at 320 pixels: cut a larger one
/// to head_and_shoulders() first. O(pixels of the mask).
[[nodiscard]] std::vector<PartLine> person_outline(const PersonMask& person, const FaceMesh& mesh);

}  // namespace touchline
