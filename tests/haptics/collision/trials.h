// Random outlines and ways for the tests of the collision tree: every shape, and every way of
// touching one, that has its own rounding or ties. Deterministic from a seed. Threads: values.
#pragma once

#include "config/types/tactile_map.h"
#include "config/types/vec2.h"
#include "haptics/collision/scene.h"
#include "tests/haptics/collision/level_segments.h"

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace touchline::trials {

/// Returns `everyday`, or `exhaustive` if TOUCHLINE_EXHAUSTIVE is set (tests/README.md).
[[nodiscard]] std::size_t count(std::size_t everyday, std::size_t exhaustive);

class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(engine_); }

    /// Returns 0 ... n - 1.
    std::size_t below(std::size_t n) {
        return std::uniform_int_distribution<std::size_t>(0, n - 1)(engine_);
    }

    /// Returns a number between two powers of ten, every decade equally likely.
    double decade(double low, double high) { return std::pow(10.0, low + (high - low) * unit()); }

    /// Returns a place in a square that extends 50 mm from the origin.
    Position place() { return {0.1 * (unit() - 0.5), 0.1 * (unit() - 0.5)}; }

    Position direction() {
        const double angle = 6.283185307179586 * unit();
        return {std::cos(angle), std::sin(angle)};
    }

  private:
    std::mt19937_64 engine_;
};

/// Returns wobbly rings, walks, two points, repeated points, random closed polygons that cross
/// themselves, corners on a grid (edges on one line, and back on themselves), several at once. At
/// most 64 segments as given.
[[nodiscard]] TactileMap small_map(Random& random);

/// Returns closed outlines only.
[[nodiscard]] TactileMap closed_map(Random& random);

/// Returns `count` triangles, crosses and single strokes of 0.05 to 2 mm all over the area.
[[nodiscard]] TactileMap tiny_outlines(Random& random, std::size_t count);

/// Builds a scene with every level that the curves have, the unsafe ones too.
[[nodiscard]] Scene every_level(const TactileMap& map, double radius_m = 0.0,
                                const CurveOptions& options = {});

/// Does the same with the vertices as given; every fourth seed splits at the usual spacing.
[[nodiscard]] Scene scene_of(const TactileMap& map, std::uint64_t seed);

/// Returns k and k + 0.1, 0.5, 0.9 for k = 0 ... coarsest, and one beyond the coarsest.
[[nodiscard]] std::vector<double> levels_of(const CurveSet& curves);

struct FromTo {
    Position from, to;
};

/// Returns a way across the scene or of a picometre: through, from and to vertices and points on
/// segments, along segments and beyond them, of no length, far away, close by.
[[nodiscard]] FromTo way(Random& random, const LevelSegments& segments);

/// Returns a way aimed at a vertex: in any direction, or along an axis, which is exact.
[[nodiscard]] FromTo way_through_vertex(Random& random, const LevelSegments& segments);

}  // namespace touchline::trials
