// What can be computed of a picture, without training, about which places belong to its main
// thing: planes that a small network sees beside the colours.
// Threads: pure functions.
#pragma once

#include <array>

#include <opencv2/core.hpp>

namespace touchline {

enum class FigureCue {
    barrier,  // how far the colours of the best way to the frame differ
    side,     // how unlike the colours at the sides of the frame
    unusual,  // how unlike the mean colour
    spread,   // how far places of this colour lie from each other
    framed,   // how much of this colour lies at the frame
    centre,   // how far from the middle of the picture
};

constexpr std::size_t figure_cue_count = 6;

/// The cues of an 8-bit BGR picture, one plane each, in the order of FigureCue, of the picture's
/// size, 0..1. The picture has at least 16 pixels a side; throws cv::Exception otherwise. The same
/// bits for the same picture on one computer. O(pixels): 4 ms for 256 x 256 on one processor.
[[nodiscard]] std::array<cv::Mat1f, figure_cue_count> figure_cues(const cv::Mat3b& picture);

}  // namespace touchline
