// How near a shape comes to lines, and which move counts as none. Threads: pure values.
#pragma once

namespace touchline {

/// A shape without radius stays this far from every line, so that rounding never changes a side.
inline constexpr double probe_gap_m = 5e-8;

/// How much nearer than that a touching edge may come while it turns: second order of a step.
inline constexpr double probe_slack_m = 3e-8;

/// How much nearer a line may be that the shape passes; otherwise every vertex of a straight line
/// would stop it.
inline constexpr double probe_graze_m = 5e-10;

/// A line this much further than the kept distance still touches.
inline constexpr double probe_touch_m = 1e-9;

/// A line this much further than the kept distance already counts; otherwise two contacts would
/// take turns.
inline constexpr double probe_mind_m = 1e-7;

/// Returns how near an edge at `distance_m` may come if it should stay `keep_m` off.
[[nodiscard]] inline double least_distance_m(double keep_m, double distance_m) {
    return keep_m - (distance_m > keep_m + probe_mind_m ? probe_graze_m : probe_slack_m);
}

/// A shorter move of a shape counts as none.
inline constexpr double probe_rest_m = 1e-10;

}  // namespace touchline
