// Where a rigid shape is and how it moves. Threads: plain values, pure functions.
#pragma once

#include "config/types/vec2.h"
#include "haptics/curve/segment.h"

#include <cmath>

namespace touchline {

/// The place of a shape's origin in W, and its turn, counter-clockwise; full turns count.
struct ProbePose {
    double x_m = 0.0;
    double y_m = 0.0;
    double angle_rad = 0.0;

    [[nodiscard]] Position place() const { return {x_m, y_m}; }

    friend bool operator==(const ProbePose&, const ProbePose&) = default;
};

[[nodiscard]] inline bool is_finite(const ProbePose& pose) {
    return std::isfinite(pose.x_m) && std::isfinite(pose.y_m) && std::isfinite(pose.angle_rad);
}

/// A straight move that turns at a steady rate on the way.
struct ProbeMove {
    Position by;
    double turn_rad = 0.0;

    /// No point within `r_max_m` of the origin moves further than this.
    [[nodiscard]] double reach_m(double r_max_m) const {
        return norm(by) + std::abs(turn_rad) * r_max_m;
    }
};

[[nodiscard]] inline ProbeMove operator*(double share, const ProbeMove& move) {
    return {share * move.by, share * move.turn_rad};
}

[[nodiscard]] inline ProbePose operator+(const ProbePose& pose, const ProbeMove& move) {
    return {pose.x_m + move.by.x, pose.y_m + move.by.y, pose.angle_rad + move.turn_rad};
}

/// The move from `from` to `to`.
[[nodiscard]] inline ProbeMove operator-(const ProbePose& to, const ProbePose& from) {
    return {to.place() - from.place(), to.angle_rad - from.angle_rad};
}

/// A pose with its sine and cosine worked out.
class ProbePlacement {
  public:
    explicit ProbePlacement(const ProbePose& pose)
        : origin_(pose.place()), cos_(std::cos(pose.angle_rad)), sin_(std::sin(pose.angle_rad)) {}

    /// Maps a point from the shape's frame to W.
    [[nodiscard]] Position operator()(Position p) const {
        return {origin_.x + (cos_ * p.x - sin_ * p.y), origin_.y + (sin_ * p.x + cos_ * p.y)};
    }

    [[nodiscard]] Segment operator()(const Segment& s) const {
        return {(*this)(s.a), (*this)(s.b)};
    }

    [[nodiscard]] Position origin() const { return origin_; }

  private:
    Position origin_;
    double cos_, sin_;
};

}  // namespace touchline
