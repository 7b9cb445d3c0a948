// A shape in a hand that presses it on a curve and turns it, a millisecond a step: what each step
// cost, and where the shape went. Threads: one.
#pragma once

#include "haptics/pantograph/profile.h"
#include "haptics/probe/probe_proxy.h"
#include "haptics/resolution/level_rule.h"
#include "tests/lab/bench/collision/run.h"
#include "tests/lab/bench/workload.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace touchline::bench {

/// Returns the hand of the peer workload, turning to and fro by up to a quarter of a turn, at most
/// 3.2 rad/s.
[[nodiscard]] std::vector<ProbePose> turning_hand(workload::Kind kind, std::size_t steps);

/// Returns a regular polygon round the hand.
[[nodiscard]] ProbeShape regular_shape(double radius_m, int edges);

struct TurningRun {
    std::vector<std::uint64_t> least_ticks;  // of each step with the hand at the shape, least of
                                             // all passes
    std::vector<ProbePose> proxies;          // of each step
    std::size_t slip_offs = 0;
    std::size_t first_slip = SIZE_MAX;  // step
    std::size_t boxes_max = 0;
};

/// Runs the shape over the hand, at a level or, without one, at the level that its speed sets. A
/// hand more than slip_m from its shape has slipped off: the shape starts again from outside the
/// curve, untimed until it is at the hand.
[[nodiscard]] TurningRun run_shape(const Scene& scene, const ProbeShape& shape,
                                   const std::vector<ProbePose>& hand, std::optional<double> level,
                                   int passes);

}  // namespace touchline::bench
