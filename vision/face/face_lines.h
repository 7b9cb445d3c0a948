// A face's mesh as lines, each of a part that can be named. Threads: pure functions.
#pragma once

#include "config/types/face_part.h"
#include "vision/contour/chain.h"
#include "vision/face/face_mesh.h"

#include <vector>

namespace touchline {

struct PartLine {
    FacePart part = FacePart::face;
    Chain line;  // smooth; the corners of eyes and mouth are fixed points
};

/// How a head is turned: the share of the face's width on the narrower side of the nose, 0.5 from
/// the front, below 0 where the nose hides that side, -1 at least; and which side that is.
struct FaceTurn {
    double narrower_share = 0.5;
    bool is_left_narrower = false;
};

[[nodiscard]] FaceTurn turn_of(const FaceMesh& mesh);

/// Whether the eyes are to be seen: the network lays a mesh on sunglasses all the same. Where
/// lenses hide them, all that is round an eye is darker than the cheek, and the eye much the same
/// all over. `picture`: 8-bit BGR, in which the mesh lies, in part at least. O(pixels of the face).
[[nodiscard]] bool shows_eyes(const cv::Mat3b& picture, const FaceMesh& mesh);

/// The lines of a face, in pixels, the ones that a hand needs first before the others: oval, eyes,
/// mouth, nose, brows, nostrils. A brow is one line; so is a closed mouth, and a closed eye. Of a
/// face that is turned away the far eye and brow and half of the nostrils go; of a near profile
/// oval, nose and all of the nostrils as well, and half of the mouth: the person's outline has
/// them.
[[nodiscard]] std::vector<PartLine> face_lines(const FaceMesh& mesh, bool has_eyes = true);

/// Closed lines round all that the face covers, pixels: its two halves, from the line through its
/// middle, nose and lips, to its sides.
[[nodiscard]] std::vector<std::vector<cv::Point2d>> face_halves(const FaceMesh& mesh);

}  // namespace touchline
