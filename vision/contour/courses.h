// The directions of strokes before they come to where they meet, and what the strokes do there: a
// corner, however sharp, a crossing, or a line that meets another; tips that thinning has turned
// into bends.
// Threads: values and pure functions.
#pragma once

#include "vision/contour/chain.h"
#include "vision/contour/junctions.h"
#include "vision/contour/skeleton.h"

#include <optional>
#include <vector>

namespace touchline {

/// The straight part of an arm next to one of its ends, beyond the ink that has flowed together.
struct Course {
    Ray ray;               // outward, towards the end
    double from_px = 0.0;  // along the arm from the end
};

/// Returns how deep the ink is at each point of an arm.
[[nodiscard]] std::vector<float> depths_of(const Chain& arm, const cv::Mat1f& depth);

/// Returns half the width of the stroke that an arm with these depths belongs to.
[[nodiscard]] double stroke_depth_px(const std::vector<float>& depths);

/// Ink deeper than this is not that of one such stroke.
[[nodiscard]] double flowed_depth_px(double stroke_depth_px);

/// The courses of all ends of a skeleton. Refers to the skeleton that it was made from.
class Courses {
  public:
    /// As joints_of(). O(points of the arms).
    Courses(const Skeleton& skeleton, const cv::Mat1f& depth, std::vector<double> usual_depth_px);

    /// Returns nothing if the arm is bent or all flowed together.
    [[nodiscard]] const std::optional<Course>& at(EndId end) const { return courses_[end]; }

    /// Returns half the width of the stroke that the arm belongs to.
    [[nodiscard]] double depth_px(EndId end) const { return own_depth_px_[chain_of(end)]; }

    /// Returns the depth at each point of an arm.
    [[nodiscard]] const std::vector<float>& depths(std::size_t arm) const { return depths_[arm]; }

  private:
    [[nodiscard]] double flowed_px(EndId end) const;
    [[nodiscard]] std::optional<Course> course_at(EndId end) const;

    const Skeleton& skeleton_;
    std::vector<std::vector<float>> depths_;
    std::vector<double> own_depth_px_;
    std::vector<std::optional<Course>> courses_;
};

/// If the ink of an arm is deeper than its stroke, and the arm turns back there by more than 145
/// degrees, two strokes have flowed together in a tip whose own arm the thinning has removed. Then
/// the arm is split in the middle of that ink, and the two ends make a node. depth: as for
/// skeleton_of(). O(points of the arms).
[[nodiscard]] Skeleton with_hairpins_parted(const Skeleton& skeleton, const cv::Mat1f& depth);

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
