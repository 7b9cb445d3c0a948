// Decodes BlazeFace's answer: where faces may be. Threads: pure functions.
#pragma once

#include <vector>

#include <opencv2/core.hpp>

namespace touchline {

/// A place where a face may be, in pixels of the network's input or of a picture.
struct FaceBox {
    cv::Rect2d box;        // from the brows to the chin
    cv::Point2d left_eye;  // on the left of an upright face
    cv::Point2d right_eye;
    double likelihood = 0.0;  // 0.5..1
};

/// The side of the network's input, the largest square of places that it knows.
inline constexpr int kFaceInput_px = 256;

/// Decodes the network's outputs. They have a row for each anchor, 16 x 16 x 2 of stride 16 and
/// then 8 x 8 x 6 of stride 32, each place's anchors one after the other, row by row. `scores`:
/// logits; `places`: centre, size and six points (x, y) about the anchor. Numbers are finite and
/// may be anything: a box that is not a box in the input, or has an eye far from it, is left out.
/// The likeliest come first, 16 at most; of two that share three tenths of the less likely, the
/// likelier stays. Source: Bazarevsky et al. 2019.
[[nodiscard]] std::vector<FaceBox> face_boxes(const cv::Mat1f& scores, const cv::Mat1f& places);

/// Adds those of `more` that lie on none of `boxes` yet, by the same measure. O(`more` x all).
void add_apart(const std::vector<FaceBox>& more, std::vector<FaceBox>& boxes);

}  // namespace touchline
