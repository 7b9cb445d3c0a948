// What strokes do where several meet: a corner, however sharp, a crossing, or a line that meets
// another. Decided by their courses beyond the place where their ink has flowed together.
// Threads: pure function.
#pragma once

#include "vision/contour/junctions.h"
#include "vision/contour/skeleton.h"

#include <vector>

namespace touchline {

struct Joints {
    std::vector<SolvedJunction> solved;
    std::vector<std::vector<EndId>> unsolved;  // ends that meet but whose courses tell nothing
    std::vector<bool> is_dropped;  // of each arm: the tip of a corner, the inside of a crossing
};

/// Solves the places where strokes meet. Where two strokes of half width h meet at an angle a,
/// their ink is one wedge from h (1 - sin) / (sin (1 + sin)) inside the corner to h / sin beyond
/// it, sin = sin(a / 2), and the skeleton has an arm along it that nobody drew. That arm is
/// dropped, and the strokes meet where their courses cross. The same holds for two strokes that
/// cross at a sharp angle, whose skeleton is two forks and a bridge. A mitre, a round and a
/// bevelled join end alike. depth: distance to the edge of the ink. O(points of the arms + ends
/// squared of each node).
[[nodiscard]] Joints joints_of(const Skeleton& skeleton, const cv::Mat1f& depth,
                               const std::vector<double>& usual_depth_px);

}  // namespace touchline
