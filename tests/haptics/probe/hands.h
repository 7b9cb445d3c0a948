// Shapes and hands for the tests of the probe. Threads: values.
#pragma once

#include "haptics/collision/scene.h"
#include "haptics/probe/probe_proxy.h"
#include "tests/haptics/collision/trials.h"

#include <vector>

namespace touchline {

[[nodiscard]] Scene scene_of_outlines(std::vector<Outline> outlines);

[[nodiscard]] ProbeShape shape_of(const Outline& outline, double radius_m = 0.0);

/// Returns a regular polygon.
[[nodiscard]] ProbeShape polygon(double radius_m, int edges);

/// Returns shape 0 ... 5: disc, bar, L, key, an open zigzag, a polygon.
[[nodiscard]] ProbeShape any_shape(std::size_t number);

/// Goes from one random place and angle to the next at up to 1 m/s and 10 rad/s.
class RestlessHand {
  public:
    explicit RestlessHand(std::uint64_t seed) : random_(seed) {}

    /// Returns the pose after another millisecond.
    ProbePose step();

  private:
    trials::Random random_;
    ProbePose pose_{0.08, 0.08, 0.0};
    ProbeMove per_step_;
    int steps_left_ = 0;
};

}  // namespace touchline
