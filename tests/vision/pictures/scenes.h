// Made-up pictures of each class, all different, for tests that need hundreds of them.
// Threads: pure functions.
#pragma once

#include <opencv2/core.hpp>

namespace touchline::testing {

/// A photo-like background of cloudy texture with a textured object before it.
struct PhotoScene {
    cv::Mat picture;  // 8-bit BGR
    cv::Mat1b truth;  // 255 where the object is
};

/// Returns one to three objects of other colours and textures, lit from a side, before a background
/// that is smooth (a sky, a wall), textured, or both. The largest object is the truth.
[[nodiscard]] PhotoScene photo_scene(int seed, cv::Size size);

/// Returns the silhouette (255 inside, any size), fitted into the middle of a photo-like
/// background.
[[nodiscard]] PhotoScene photo_of(const cv::Mat1b& silhouette, int seed, cv::Size size);

/// Returns flat colours: logos, pie and bar charts, overlapping shapes, flags, pictograms, with a
/// title.
[[nodiscard]] cv::Mat diagram(int seed, cv::Size size);

/// Returns pen on paper: doodles, handwriting, maps of borders, technical drawings; some white on
/// black.
[[nodiscard]] cv::Mat line_drawing(int seed, cv::Size size);

/// Returns a printed page: lines of words in one or two columns, a heading, sometimes a figure.
[[nodiscard]] cv::Mat text_page(int seed, cv::Size size);

}  // namespace touchline::testing
