#include "tests/lab/bench/collision/tiled_spiral.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace touchline::bench {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;
constexpr double outer_m = 0.038;
constexpr double inner_m = 0.008;
constexpr double pitch_m = 0.0015;
constexpr double ripple_m = 6e-5;
constexpr double ripples_per_turn = 40.0;
constexpr double tile_m = 5e-6;
constexpr double end_angle = two_pi * (outer_m - inner_m) / pitch_m;

/// Returns the length of the spiral without its ripple up to an angle; the pitch is small beside
/// the radius.
double length_m(double angle) {
    return outer_m * angle - pitch_m / two_pi * angle * angle / 2.0;
}

double angle_at(double s_m) {
    constexpr double fall_m = pitch_m / two_pi;
    return (outer_m - std::sqrt(std::max(0.0, outer_m * outer_m - 2.0 * fall_m * s_m))) / fall_m;
}

Position on_spiral(double s_m, double out_m) {
    const double angle = angle_at(s_m);
    const double r =
        outer_m - pitch_m * angle / two_pi + ripple_m * std::sin(ripples_per_turn * angle) + out_m;
    return {r * std::cos(angle), r * std::sin(angle)};
}

}  // namespace

TactileMap tiled_spiral(std::size_t edges, std::size_t outlines) {
    const std::size_t of_each = edges / outlines;
    const std::size_t overlap = std::min<std::size_t>(3, of_each - 1);
    const double edge_m = length_m(end_angle) / static_cast<double>(of_each * outlines);
    TactileMap map;
    for (std::size_t k = 0; k < outlines; ++k) {
        Outline outline;
        const std::size_t first = k * of_each;
        const std::size_t back = k > 0 ? overlap : 0;
        for (std::size_t i = first - back; i <= first + of_each; ++i) {
            // Falls by one tile from its start to its end, so that all tiles lie alike.
            const double share =
                static_cast<double>(i + back - first) / static_cast<double>(of_each + back);
            const double out_m = outlines > 1 ? tile_m * (share - 1.0) : 0.0;
            outline.points.push_back(on_spiral(edge_m * static_cast<double>(i), out_m));
        }
        map.outlines.push_back(std::move(outline));
    }
    return map;
}

std::vector<Position> hand_on_spiral(std::size_t steps) {
    std::vector<Position> hand;
    double s_m = 0.002;
    const double last_m = length_m(end_angle) - 0.002;
    for (std::size_t i = 0; i < steps && s_m < last_m; ++i) {
        const double t = 1e-3 * static_cast<double>(i);
        hand.push_back(on_spiral(s_m, -0.0003 + 0.0007 * std::cos(two_pi * 2.5 * t)));
        s_m += 1e-3 * 0.15 * (1.0 - std::cos(two_pi * 0.25 * t));
    }
    return hand;
}

}  // namespace touchline::bench
