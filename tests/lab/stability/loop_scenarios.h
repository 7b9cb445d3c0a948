// The torture geometry of the stability scenarios S01 to S15, with a hand for the whole loop.
// Threads: immutable once made, on the first call.
#pragma once

#include "haptics/collision/scene.h"
#include "tests/lab/bench/contact/torture.h"

#include <functional>
#include <vector>

namespace touchline::stability {

struct LoopScenario {
    bench::Torture torture;
    Scene scene;
    double radius_m = 0.0;                               // the proxy's, if it has one
    std::function<double(double t_s)> level{};           // wanted; without it 0, the finest
    std::function<const Scene*(double t_s)> scene_at{};  // felt; without it `scene`, all the time

    /// Whether renderers that know only one curve of whole edges can run it.
    [[nodiscard]] bool is_plain() const { return !torture.ring.empty(); }
};

/// Returns the scenarios: S02, S05, S08 and S10 are those of the bench; S01 flat line, S03 convex
/// vertices, S04 polygons, S06 swipes, S07 strands whose coarse levels would cross, S09 a circle
/// whose level changes every 50 ms, S11 doubled edges, S12 100 000 pieces, S13 gaps, S14 tremor,
/// S15 a drawing that grows.
[[nodiscard]] const std::vector<LoopScenario>& loop_scenarios();

}  // namespace touchline::stability
