// Photos of pages as a camera over a table takes them, drawn from a seed, with known corners; and
// photos without a page.
#pragma once

#include "vision/prepare/quad.h"

#include <random>

namespace touchline::testing {

/// The difficulties of a photo; 0 means none.
struct Hardship {
    double shade = 0.0;      // how much darker the dark side is, 0 ... 1
    double tilt = 0.15;      // how unequal opposite sides are, 0 ... 0.4
    double turn_deg = 10.0;  // at most, either way
    double clutter = 0.0;    // things on the table, 0 ... 1
    double noise_levels = 2.0;
    double blur_px = 0.8;
    double desk_level = 90.0;  // the table's brightness
    double page_share = 0.5;   // share of the picture's height, about
    cv::Point2d shift;         // of the page, in its own sizes
    bool has_content = true;
};

struct PagePhoto {
    cv::Mat bgr;
    Quad corners;  // in the order of ordered()
    double aspect = 1.0;
};

/// Returns a photo of 800 x 600.
[[nodiscard]] PagePhoto page_photo(unsigned seed, const Hardship& hardship);

/// Returns the page itself: white, with lines of letters, drawings and filled shapes.
[[nodiscard]] cv::Mat page_content(std::mt19937& random, cv::Size size);

/// Returns a photo without a page: plain, noise, clouds (1/f), stripes, bricks, small checks,
/// blobs, polygons with other than four corners, small cards, dark sheets.
[[nodiscard]] cv::Mat pageless_photo(unsigned seed);

/// Adds a lamp mirrored in the page: a clipped spot of this radius.
void add_glare(cv::Mat& bgr, cv::Point2d centre, double radius_px);

/// Darkens the picture from side to side at this angle, down to 1 - shade.
void add_shade(cv::Mat& bgr, double shade, double angle_rad);

}  // namespace touchline::testing
