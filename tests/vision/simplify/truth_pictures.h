// Pictures whose outlines are known: glyphs of a font, pictograms, overlapping shapes, strokes.
// Everything in pixels of the picture, from the upper left corner of the upper left pixel.
#pragma once

#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace touchline::testing {

struct TruthPicture {
    std::string name;
    cv::Mat pixels;                               // 8-bit BGR
    std::vector<std::vector<cv::Point2d>> rings;  // closed outlines, where they are known
};

/// How many there are: glyphs, pictograms, scenes and strokes in turns.
inline constexpr int kTruthPictures = 320;

/// The n-th of them, the same on every call; 0 <= n < kTruthPictures.
[[nodiscard]] TruthPicture truth_picture(int n);

}  // namespace touchline::testing
