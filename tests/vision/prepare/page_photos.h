// Photos of pages as a camera over a table takes them, drawn from a seed, with the corners known;
// and photos without a page.
#pragma once

#include "vision/prepare/quad.h"

#include <random>

namespace touchline::testing {

/// What is hard about a photo, each 0 for not at all.
struct Hardship {
    double shade = 0.0;      // how much darker the dark side is, 0 ... 1
    double tilt = 0.15;      // how unequal opposite sides are, 0 ... 0.4
    double turn_deg = 10.0;  // at most, either way
    double clutter = 0.0;    // things on the table, 0 ... 1
    double noise_levels = 2.0;
    double blur_px = 0.8;
    double desk_level = 90.0;  // the table's brightness
    double page_share = 0.5;   // of the picture's height, about
    cv::Point2d shift;         // of the page, in its own sizes
    bool has_content = true;
};

struct PagePhoto {
    cv::Mat bgr;
    Quad corners;  // ordered() as it lies
    double aspect = 1.0;
};

/// 800 x 600.
[[nodiscard]] PagePhoto page_photo(unsigned seed, const Hardship& hardship);

/// The page itself: white, with lines of letters, drawings and filled shapes.
[[nodiscard]] cv::Mat page_content(std::mt19937& random, cv::Size size);

/// No page in it: plain, noise, clouds (1/f), stripes, bricks, small checks, blobs, polygons with
/// other than four corners, small cards, dark sheets.
[[nodiscard]] cv::Mat pageless_photo(unsigned seed);

/// A lamp mirrored in the page: a clipped spot of this radius.
void add_glare(cv::Mat& bgr, cv::Point2d centre, double radius_px);

/// Darker from side to side, at this angle, down to 1 - shade.
void add_shade(cv::Mat& bgr, double shade, double angle_rad);

}  // namespace touchline::testing
