// Pictures whose outlines are known: glyphs of a font, pictograms, overlapping shapes, strokes. All
// coordinates are in pixels of the picture, from the upper left corner of the upper left pixel.
#pragma once

#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace touchline::testing {

struct TruthPicture {
    std::string name;
    cv::Mat pixels;                               // 8-bit BGR
    std::vector<std::vector<cv::Point2d>> rings;  // closed outlines, if known
};

/// The number of pictures: glyphs, pictograms, scenes and strokes in turn.
inline constexpr int kTruthPictures = 320;

/// Returns the n-th picture, the same on every call; 0 <= n < kTruthPictures.
[[nodiscard]] TruthPicture truth_picture(int n);

}  // namespace touchline::testing
