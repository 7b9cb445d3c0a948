// A face as the points that a network lays on it, and boxes in a picture, whose numbers may be any,
// because they come from networks. The mesh as lines, each for a part that has a name, and the
// outline of its person: hair or hat, neck, shoulders. Threads: plain values and pure functions.
#pragma once

#include "config/types/thing_name.h"
#include "vision/contour/chain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <opencv2/core.hpp>

namespace touchline {

/// Pixels of the picture, in the order of MediaPipe's FaceMesh. Its numbers count from 0: 10 is the
/// top of the forehead, 152 the chin, 1 the tip of the nose, 234 and 454 the sides of the face, 33
/// and 263 the outer corners of the eyes; 33 and 234 are on the left as long as the head is
/// upright.
using FaceMesh = std::array<cv::Point2d, 468>;

/// Returns the upright box that holds it. O(points).
[[nodiscard]] inline cv::Rect2d box_of(const FaceMesh& mesh) {
    const auto [left, right] = std::ranges::minmax(mesh, {}, &cv::Point2d::x);
    const auto [top, bottom] = std::ranges::minmax(mesh, {}, &cv::Point2d::y);
    return {left.x, top.y, right.x - left.x, bottom.y - top.y};
}

[[nodiscard]] inline cv::Point2d centre_of(const cv::Rect2d& box) {
    return 0.5 * (box.tl() + box.br());
}

/// Returns how far to turn the picture's upright to get the face's: the angle of the line through
/// the outer corners of the eyes, radians, y down, positive clockwise as seen.
[[nodiscard]] inline double tilt_of(const FaceMesh& mesh) {
    const cv::Point2d across = mesh[263] - mesh[33];
    return std::atan2(across.y, across.x);
}

/// Returns the part of the box that lies in the picture, pixels. Empty if there is none, if a side
/// of the box is negative, or if its numbers are NaN.
[[nodiscard]] inline cv::Rect2d box_within(const cv::Rect2d& box, cv::Size picture) {
    const double left = std::max(box.x, 0.0);
    const double top = std::max(box.y, 0.0);
    const double right = std::min(box.x + box.width, static_cast<double>(picture.width));
    const double bottom = std::min(box.y + box.height, static_cast<double>(picture.height));
    if (!(right > left && bottom > top)) return {};
    return {left, top, right - left, bottom - top};
}

/// The same in whole pixels. It rounds corners: a rounded side beside a rounded corner may end
/// beyond the picture.
[[nodiscard]] inline cv::Rect part_within(const cv::Rect2d& box, cv::Size picture) {
    const cv::Rect2d within = box_within(box, picture);
    return cv::Rect(cv::Point(within.tl()), cv::Point(within.br())) & cv::Rect({}, picture);
}

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
