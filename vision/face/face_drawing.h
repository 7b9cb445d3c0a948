// Draws a face in a picture, with its person, as a map of its own.
// Threads: one at a time for a network.
#pragma once

#include "vision/face/face_map.h"
#include "vision/face/person_network.h"

namespace touchline {

/// Returns the map of a mesh that lies on a face of an 8-bit BGR picture, in the area's usual size.
/// Fails as the network does. 24 ms on one core.
[[nodiscard]] Result<FaceMap> drawn_face(const cv::Mat3b& picture, const FaceMesh& mesh,
                                         PersonNetwork& persons);

}  // namespace touchline
