// Restores tips that thinning has turned into bends.
// Threads: pure function.
#pragma once

#include "vision/contour/skeleton.h"

namespace touchline {

/// If the ink of an arm is deeper than its stroke, and the arm turns back there by more than 145
/// degrees, two strokes have flowed together in a tip whose own arm the thinning has removed. Then
/// the arm is split in the middle of that ink, and the two ends make a node. depth: as for
/// skeleton_of(). O(points of the arms).
[[nodiscard]] Skeleton with_hairpins_parted(const Skeleton& skeleton, const cv::Mat1f& depth);

}  // namespace touchline
