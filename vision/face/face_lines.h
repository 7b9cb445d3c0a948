// A face's mesh as lines, each for a part that has a name, and the outline of its person: hair or
// hat, neck, shoulders. Threads: pure functions.
#pragma once

#include "config/types/thing_name.h"
#include "vision/contour/chain.h"
#include "vision/face/face_mesh.h"

#include <vector>

namespace touchline {

struct PartLine {
    FacePart part = FacePart::face;
    Chain line;  // smooth; the corners of eyes and mouth are fixed points
};

/// How a head is turned: the share of the face's width on the narrower side of the nose, 0.5 from
/// the front, below 0 if the nose hides that side, at least -1; and which side that is.
struct FaceTurn {
    double narrower_share = 0.5;
    bool is_left_narrower = false;
};

[[nodiscard]] FaceTurn turn_of(const FaceMesh& mesh);

/// Returns whether the eyes are visible, because the network lays a mesh on sunglasses too. If
/// lenses hide the eyes, everything round an eye is darker than the cheek, and the eye is nearly
/// uniform. `picture`: 8-bit BGR, in which the mesh lies, at least in part. O(pixels of the face).
[[nodiscard]] bool shows_eyes(const cv::Mat3b& picture, const FaceMesh& mesh);

/// Returns the lines of a face, in pixels, the ones that a hand needs first before the others:
/// oval, eyes, mouth, nose, brows, nostrils. A brow is one line, as are a closed mouth and a closed
/// eye. On a face that is turned away, the far eye and brow and half of the nostrils are left out;
/// on a near profile also the oval, the nose, all of the nostrils and half of the mouth, which are
/// part of the person's outline.
[[nodiscard]] std::vector<PartLine> face_lines(const FaceMesh& mesh, bool has_eyes = true);

/// Returns closed lines round everything that the face covers, pixels: its two halves, from the
/// line through its middle, nose and lips, to its sides.
[[nodiscard]] std::vector<std::vector<cv::Point2d>> face_halves(const FaceMesh& mesh);

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
