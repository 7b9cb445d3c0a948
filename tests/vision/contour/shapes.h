// Shapes with known outlines, drawn as a camera would see them, and how far apart two sets of
// outlines are. All coordinates are in pixels of the picture, from the upper left corner of the
// upper left pixel.
#pragma once

#include "vision/contour/photo_lines.h"

#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace touchline::testing {

using Ring = std::vector<cv::Point2d>;

/// Filled by the even-odd rule: a ring inside a ring is a hole.
struct Shape {
    std::string name;
    std::vector<Ring> rings;
};

/// Returns a disc, a square, a five-pointed star and the letters A, L and R, about `size_px` large
/// round the centre, turned by `angle_deg`.
[[nodiscard]] std::vector<Shape> test_shapes(cv::Point2d centre, double size_px, double angle_deg);

struct Look {
    cv::Scalar ink{0, 0, 0};  // BGR
    cv::Scalar paper{255, 255, 255};
    double blur_px = 0.0;       // Gaussian sigma
    double noise_levels = 0.0;  // standard deviation, grey noise
    int seed = 1;
};

/// Takes 8 x 8 samples a pixel, averages over the area, blurs, then adds noise; 8-bit BGR.
[[nodiscard]] cv::Mat drawn(const Shape& shape, cv::Size size, const Look& look);

/// Returns the lines in picture pixels; closed ones repeat their first point.
[[nodiscard]] std::vector<Ring> lines_in_pixels(const PhotoLines& found, cv::Size picture);

/// Greatest distances between truth and outlines, both ways, by place on the shape.
struct Distances {
    double smooth_px = 0.0;  // farther than 3 px from every corner
    double corner_px = 0.0;  // within 3 px of a corner of at least 90 degrees
    double tip_px = 0.0;     // within 3 px of a sharper one
};

[[nodiscard]] Distances distances(const Shape& truth, const std::vector<Ring>& lines);

}  // namespace touchline::testing
