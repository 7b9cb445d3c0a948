// Pictures with marked boundaries.
// Threads: pure functions.
#pragma once

#include "config/types/result.h"

#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace touchline::bench {

struct MarkedPicture {
    cv::Mat picture;                    // 8-bit BGR
    std::vector<cv::Mat1b> annotators;  // boundaries are not 0
};

/// Returns a picture's pixels, 8-bit BGR.
[[nodiscard]] Result<cv::Mat> pixels_of(const std::string& path);

/// Makes pictograms before photo-like backgrounds.
[[nodiscard]] std::vector<MarkedPicture> made_pictures();

/// Returns a folder's NAME.jpg, each with NAME-human1.png ..., by name.
[[nodiscard]] Result<std::vector<MarkedPicture>> pictures_in(const std::string& folder);

/// A photograph whose main thing somebody has marked.
struct FigurePicture {
    std::string name;
    MarkedPicture marked;
    cv::Mat1b truth;  // the picture's size; 128 and more: the thing
};

/// Returns those of a folder that have a mask of the same name in another: TRUTHS/NAME.png.
[[nodiscard]] Result<std::vector<FigurePicture>> pictures_in(const std::string& folder,
                                                             const std::string& truths);

/// Returns a folder's NAME.jpg, by name, without marks.
[[nodiscard]] Result<std::vector<cv::Mat>> bare_pictures_in(const std::string& folder);

}  // namespace touchline::bench
