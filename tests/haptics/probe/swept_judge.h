// An independent judge of a turning shape: knows the segments of a scene as rendered, the shape's
// edges and exact predicates, but no trees, fronts or separating directions.
#pragma once

#include "haptics/curve/curve_set.h"
#include "haptics/probe/probe_shape.h"

#include <span>
#include <vector>

namespace touchline {

class SweptJudge {
  public:
    SweptJudge(const CurveSet& curves, double level, std::span<const Segment> shape);

    /// Whether no line passes through an edge of the shape while it moves from pose to pose. Checks
    /// the ends of the edges against the lines, and in the shape's frame the ends of the lines
    /// against the edges. Follows their ways in chords that leave them by at most 3 nm.
    [[nodiscard]] bool is_free(std::span<const ProbePose> path) const;

    /// Whether no line meets the shape there.
    [[nodiscard]] bool is_clear(const ProbePose& pose) const;

    /// Returns the least distance between any line and any edge.
    [[nodiscard]] double distance_m(const ProbePose& pose) const;

  private:
    [[nodiscard]] bool is_free(const ProbePose& from, const ProbePose& to) const;
    [[nodiscard]] std::vector<Segment> near(const ProbePose& from, double reach_m) const;

    std::vector<Segment> segments_;
    std::vector<Segment> shape_;
    double r_max_m_ = 0.0;
};

}  // namespace touchline
