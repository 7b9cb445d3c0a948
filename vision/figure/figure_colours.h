// A likelihood of the main thing, drawn onto where the picture's colours change.
// Threads: pure function of its arguments, except that it sets OpenCV's random state of the calling
// thread (and restores it).
#pragma once

#include <opencv2/core.hpp>

namespace touchline {

/// `likelihood`: 0..1, a place is figure from `limit` on (above 0, below 1); over the whole of an
/// 8-bit BGR picture, stretched or not. Returns one in the picture's proportions, its longer side
/// as long as the picture's, but at least 224 and at most 500 pixels, by the limit 0.3 of
/// figures.h: GrabCut decides on which side of the limit a place is that is neither surely figure
/// nor surely ground, and the likelihood how far from it; then it decides again, finer, in a band
/// of 3 % of the longer side round that ring. Places on both sides of the ring are equally far from
/// the limit. Where the colours disagree with most of the likelihood, as for a hidden animal, they
/// decide nothing. Deterministic. Some 100 ms on one processor, whatever the size.
[[nodiscard]] cv::Mat1f drawn_by_colours(const cv::Mat1f& likelihood, float limit,
                                         const cv::Mat3b& picture);

}  // namespace touchline
