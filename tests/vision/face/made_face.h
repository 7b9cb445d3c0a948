// A face made of formulas, turned and seen from in front: the points that the lines use.
// Threads: pure functions.
#pragma once

#include "vision/face/face_lines.h"

#include <string>

namespace touchline::testing {

/// The size of the picture with the face.
inline const cv::Size made_picture(640, 480);

struct MadeFace {
    double turn_rad = 0.0;  // to the right of the picture
    double nod_rad = 0.0;   // down
    double tilt_rad = 0.0;  // clockwise
    double half_width_px = 60.0;
    cv::Point2d middle{300.0, 220.0};
    double mouth_open = 0.0;  // 0..1
    double eyes_open = 1.0;   // 0..1
    double skew = 0.0;        // x grows with y
    double stretch = 1.0;     // applied to y

    [[nodiscard]] FaceMesh mesh() const;

    [[nodiscard]] std::string words() const;
};

/// Returns the mesh with its mouth wide open: lips on an ellipse, where no angle shows the corners.
[[nodiscard]] FaceMesh with_round_mouth(FaceMesh mesh);

/// Returns a portrait of the face: hair, skin in soft light, eyes, brows, nose, lips.
[[nodiscard]] cv::Mat3b portrait_of(const MadeFace& face);

/// Returns the head and shoulders behind such a face; the head is this much larger than the face.
[[nodiscard]] PersonMask made_person(const MadeFace& face, double hair);

}  // namespace touchline::testing
