// How near a shape comes to lines. Threads: constants, pure functions.
#pragma once

namespace touchline {

/// A shape without radius stays this far from every line, so that rounding never changes a side.
inline constexpr double probe_gap_m = 5e-8;

/// How much nearer than that a touching edge may come while it turns: second order of a step.
inline constexpr double probe_slack_m = 3e-8;

/// How much nearer a line may be that is passed by: else every vertex of a straight line stops it.
inline constexpr double probe_graze_m = 5e-10;

/// Further by this than it is kept, and still touching.
inline constexpr double probe_touch_m = 1e-9;

/// Further by this than it is kept, and already minded: else two contacts take turns.
inline constexpr double probe_mind_m = 1e-7;

/// How near an edge at this distance may come that should stay `keep_m` off.
[[nodiscard]] inline double least_distance_m(double keep_m, double distance_m) {
    return keep_m - (distance_m > keep_m + probe_mind_m ? probe_graze_m : probe_slack_m);
}

}  // namespace touchline
