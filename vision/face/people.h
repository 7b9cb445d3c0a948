// Finds where people are in a picture. Threads: one at a time for a network.
#pragma once

#include "vision/face/person_network.h"

#include <span>

namespace touchline {

/// Returns how likely each pixel of an 8-bit BGR picture belongs to a person, 0..1; 0 outside of
/// `people`, boxes in its pixels, each grown by 0.04 of its longer side on all sides. Boxes of an
/// eightieth of the picture or more count, at most five, in their order. Boxes may be anything:
/// those that lie beside the picture, have no size, or have NaN or infinite numbers do not count.
/// Fails as the network does. 11 ms for each on one core.
[[nodiscard]] Result<cv::Mat1f> people_likelihood(const cv::Mat3b& picture,
                                                  std::span<const cv::Rect2d> people,
                                                  PersonNetwork& network);

}  // namespace touchline
