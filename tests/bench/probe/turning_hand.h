// A shape in a hand that presses it on a curve and turns it, a millisecond a step: what each step
// cost, and where the shape went. Threads: one.
#pragma once

#include "haptics/pantograph/profile.h"
#include "haptics/probe/probe_proxy.h"
#include "haptics/resolution/shape_level_rule.h"
#include "tests/bench/collision/run.h"
#include "tests/bench/workload.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace touchline::bench {

/// The hand of the peer workload, turning to and fro by up to a quarter of a turn, 3.2 rad/s at
/// most.
[[nodiscard]] std::vector<ProbePose> turning_hand(workload::Kind kind, std::size_t steps);

/// A regular polygon round the hand.
[[nodiscard]] ProbeShape regular_shape(double radius_m, int edges);

struct TurningRun {
    std::vector<std::uint64_t> least_ticks;  // of each step with the hand at the shape, least of
                                             // all passes
    std::vector<ProbePose> proxies;          // of each step
    std::size_t slip_offs = 0;
    std::size_t first_slip = SIZE_MAX;  // step
    std::size_t boxes_max = 0;
};

/// The shape over the hand, at a level or, without one, at that by speed. A hand more than slip_m
/// from its shape has slipped off: the shape is set on again from outside the curve, untimed until
/// it is at the hand.
[[nodiscard]] TurningRun run_shape(const Scene& scene, const ProbeShape& shape,
                                   const std::vector<ProbePose>& hand, std::optional<double> level,
                                   int passes);

}  // namespace touchline::bench
